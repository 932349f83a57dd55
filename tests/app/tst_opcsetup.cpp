#include "app/server/gatewayregistration.h"
#include "app/server/opcsetup.h"
#include "core/opc/opclines.h"
#include "tests/core/opc/opcsite.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;

/// The first run of manual 000, 11.5.
class TestOpcSetup : public QObject
{
    Q_OBJECT

private:
    /// What a run tells the journal; \a done: what it tells the window, once at most.
    static QStringList run(const QString &folder, const QList<OpcTag> &tags, int port, QStringList *done = nullptr)
    {
        OpcSetup setup(folder, tags);
        QStringList told;
        QStringList messages;
        connect(&setup, &OpcSetup::journal, &setup, [&told](const JournalEntry &entry) { told.append(entry.text); });
        connect(&setup, &OpcSetup::done, &setup, [&messages](const QString &message) { messages.append(message); });
        setup.run(port);
        if (done != nullptr) {
            *done = messages;
        }
        return told;
    }

    static QByteArray bytes(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void writesTheListOnce()
    {
        const QTemporaryDir folder;
        const QList<OpcTag> tags = opcTags(opcSite().lines);
        const QString list = folder.filePath(u"OPC/tags.txt"_s);
        QStringList done;
        const QStringList told = run(folder.path(), tags, 43212, &done);
        QCOMPARE(told.first(), u"OPC DA: the list of tags is new (tags: 32). It was written to %1."_s.arg(list));
        QCOMPARE(done, QStringList{told.join(u'\n')});
        const QList<QByteArray> lines = bytes(list).split('\n');
        QCOMPARE(lines.size(), 33);
        QVERIFY(lines.first().startsWith("[COM5].Sensor_001[AND3][Addr:002].STATE.Restart\tbool\t"));
        QVERIFY(bytes(folder.filePath(u"OPC/tags.jsonl"_s))
                    .startsWith("{\"tags\":[{\"aliases\":[\"[COM5].Sensor_001[AND3][Addr:002].STATUS.Restart\"],"));
        QCOMPARE(run(folder.path(), tags, 43212, &done), QStringList());
        QCOMPARE(done, QStringList());
    }

    void anotherListOrPortIsNewAgain()
    {
        const QTemporaryDir folder;
        QList<LineConfig> lines = opcSite().lines;
        run(folder.path(), opcTags(lines), 43212);
        QVERIFY(!run(folder.path(), opcTags(lines), 43213).isEmpty());
        lines[0].sensors[0].address = 7;
        QVERIFY(!run(folder.path(), opcTags(lines), 43213).isEmpty());
        QVERIFY(run(folder.path(), opcTags(lines), 43213).isEmpty());
    }

    /// It says so, and tries again the next time.
    void aFolderThatCannotBeWritten()
    {
        const QTemporaryDir folder;
        QFile obstacle(folder.filePath(u"OPC"_s));
        QVERIFY(obstacle.open(QIODevice::WriteOnly));
        obstacle.close();
        QStringList done;
        QStringList told = run(folder.path(), opcTags(opcSite().lines), 43212, &done);
        QCOMPARE(told.size(), 1);
        QVERIFY2(told.first().contains(u"OPC/tags.txt cannot be written ("), qPrintable(told.first()));
        QCOMPARE(done, told);
        QVERIFY(obstacle.remove());
        told = run(folder.path(), opcTags(opcSite().lines), 43212);
        QVERIFY2(told.first().contains(u"the list of tags is new"), qPrintable(told.first()));
    }

    /// Where nothing can be registered, a gateway with another list is no reason to do anything.
    void renewsOnlyWhereItCan()
    {
        const QTemporaryDir folder;
        run(folder.path(), opcTags(opcSite().lines), 43212);
        OpcSetup setup(folder.path(), opcTags(opcSite().lines));
        int messages = 0;
        connect(&setup, &OpcSetup::done, &setup, [&messages] { ++messages; });
        setup.renew(43212);
        QCOMPARE(messages, canRegisterGateways() ? 1 : 0);
        QCOMPARE(QFile::exists(folder.filePath(u"OPC/registered"_s)), !canRegisterGateways());
    }

    /// The words that the gateway understands.
    void argumentsOfTheRegistration()
    {
        QCOMPARE(
            registrationArguments(43212, "abc", QDir::fromNativeSeparators(u"/d/OPC/tags.jsonl"_s)),
            (QStringList{
                u"/RegServer"_s, u"/Port=43212"_s, u"/Hash=abc"_s,
                u"/Tags="_s + QDir::toNativeSeparators(u"/d/OPC/tags.jsonl"_s)}));
    }
};

QTEST_GUILESS_MAIN(TestOpcSetup)
#include "tst_opcsetup.moc"
