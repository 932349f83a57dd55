#include "translations/translation.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

using namespace gorizont;

namespace {

/// The sources of all entries of a .ts file that nobody has translated; all of them with \a isEverything.
QStringList entries(const QString &path, bool isEverything)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {QStringLiteral("cannot open ") + path};
    }
    QStringList list;
    QString context;
    QString source;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"source") {
            source = xml.readElementText();
        } else if (xml.name() == u"translation") {
            const bool isOpen = xml.attributes().hasAttribute(QLatin1String("type"));
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            if (isEverything || isOpen || text.trimmed().isEmpty()) {
                list += context + QStringLiteral(": ") + source;
            }
        }
    }
    if (xml.hasError()) {
        list += xml.errorString();
    }
    return list;
}

QString committed(const QString &language)
{
    return QStringLiteral(GORIZONT_SOURCE_DIR "/translations/gorizont_%1.ts").arg(language);
}

} // namespace

class TestTranslations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        for (const QString &language : {QStringLiteral("ru"), QStringLiteral("en")}) {
            QVERIFY(QFile::copy(committed(language), fresh(language)));
            QFile::setPermissions(fresh(language), QFile::ReadOwner | QFile::WriteOwner);
        }
        QProcess update;
        update.setProcessChannelMode(QProcess::MergedChannels);
        update.start(
            QStringLiteral(GORIZONT_SOURCE_DIR "/translations/update.sh"),
            {QStringLiteral(GORIZONT_LUPDATE), QStringLiteral(GORIZONT_SOURCE_DIR), m_folder.path()});
        QVERIFY(update.waitForFinished(60000));
        QVERIFY2(update.exitCode() == 0, update.readAll().constData());
    }

    void languages_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("ru") << QStringLiteral("ru");
        QTest::newRow("en") << QStringLiteral("en");
    }

    /// Build the target update_translations, translate what it adds, and this is content again.
    void everySentenceIsTranslated_data() { languages_data(); }
    void everySentenceIsTranslated()
    {
        QFETCH(QString, language);
        QCOMPARE(entries(fresh(language), false), QStringList());
    }

    /// What no source says any more has been taken out.
    void nothingIsLeftOver_data() { languages_data(); }
    void nothingIsLeftOver()
    {
        QFETCH(QString, language);
        QCOMPARE(entries(committed(language), true), entries(fresh(language), true));
    }

    void russianWordsOfTheManual()
    {
        QVERIFY(installTranslation({}));
        QCOMPARE(QCoreApplication::translate("gorizont::StatePanel", "Sensors"), QStringLiteral("Датчики"));
        QCOMPARE(
            QCoreApplication::translate("SensorPage", "Angles Mx, My, degrees (arc-seconds)"),
            QStringLiteral("Углы Мх, Му, град. (угл. сек.)"));
        const auto attention = [](int count) {
            return QCoreApplication::translate("AlarmText", "%n sensor(s) need attention", nullptr, count);
        };
        QCOMPARE(attention(1), QStringLiteral("1 датчик требует внимания"));
        QCOMPARE(attention(22), QStringLiteral("22 датчика требуют внимания"));
        QCOMPARE(attention(11), QStringLiteral("11 датчиков требуют внимания"));
    }

    void englishPlurals()
    {
        QVERIFY(installTranslation(QStringLiteral("en")));
        QCOMPARE(QCoreApplication::translate("gorizont::StatePanel", "Sensors"), QStringLiteral("Sensors"));
        QCOMPARE(
            QCoreApplication::translate("AlarmText", "%n sensor(s) need attention", nullptr, 1),
            QStringLiteral("1 sensor needs attention"));
    }

    void unknownLanguage()
    {
        QVERIFY(!installTranslation(QStringLiteral("xx")));
        QCOMPARE(QCoreApplication::translate("gorizont::StatePanel", "Sensors"), QStringLiteral("Sensors"));
    }

private:
    QString fresh(const QString &language) const
    {
        return m_folder.filePath(QStringLiteral("gorizont_%1.ts").arg(language));
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
