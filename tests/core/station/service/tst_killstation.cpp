#include "core/station/service/periodrecords.h"
#include "core/station/service/stationstorage.h"

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

using namespace gorizont;
using namespace gorizont::station;

namespace {

const QString fileName = QStringLiteral("2026_11_obj001.txt");
const QByteArray heading = ";time\tT01\n";

QByteArray recordOf(int number)
{
    return "2026-11-28 18:30:00\t" + QByteArray::number(number).rightJustified(200, '0') + '\n';
}

/// What is killed: writes as fast as it can, and tells its parent about every record that is finished.
int writeUntilKilled(const QString &folder, int from)
{
    StationStorage storage(folder);
    for (int i = from;; ++i) {
        storage.add({fileName, heading, recordOf(i)});
        QCoreApplication::sendPostedEvents(&storage);
        const QByteArray told = QByteArray::number(i) + '\n';
        if (::write(STDOUT_FILENO, told.constData(), static_cast<std::size_t>(told.size())) != told.size()) {
            return 1;
        }
    }
}

} // namespace

class TestKillStation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRecordIsWhole();
};

void TestKillStation::everyRecordIsWhole()
{
    QTemporaryDir folder;
    int written = 0; // records that the children have said to be finished
    for (int round = 0; round < 10; ++round) {
        QProcess child;
        child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        child.start(
            QCoreApplication::applicationFilePath(),
            {QStringLiteral("--write"), folder.path(), QString::number(written)});
        QVERIFY(child.waitForReadyRead(30'000));
        QTest::qSleep(static_cast<int>(QRandomGenerator::global()->bounded(5, 60)));
        child.kill();
        QVERIFY(child.waitForFinished(30'000));
        QByteArrayList told = child.readAllStandardOutput().split('\n');
        told.removeLast();
        QVERIFY(!told.isEmpty());
        const int finished = told.constLast().toInt() + 1;

        // The next writer goes on in the same file; what it finds is whole, up to the last record that was told.
        QFile file(folder.filePath(fileName));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray content = file.readAll();
        const qsizetype whole = content.lastIndexOf('\n') + 1;
        QByteArray expected = heading;
        for (int i = 0; i < finished; ++i) {
            expected += recordOf(i);
        }
        QVERIFY2(content.first(whole).startsWith(expected), QByteArray::number(round));
        // At most one that was written was not told any more.
        QVERIFY(content.first(whole) == expected || content.first(whole) == expected + recordOf(finished));
        written = content.first(whole) == expected ? finished : finished + 1;
    }
}

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == u"--write") {
        return writeUntilKilled(arguments.value(2), arguments.value(3).toInt());
    }
    TestKillStation test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_killstation.moc"
