#include "core/history/capturefolder.h"
#include "core/history/historywriter.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

SignalCapture captured(int number, int channel, CaptureKind kind = CaptureKind::Waveform)
{
    SignalCapture signal;
    signal.number = number;
    signal.kind = kind;
    signal.time = moscow("2018-02-07T18:33:03");
    signal.information.channel = channel;
    signal.information.rate = 4;
    signal.information.physicalK = 0.5;
    signal.information.physicalB = 1;
    signal.information.windowSum = 2;
    signal.codes = {-4, 2};
    return signal;
}

const QByteArray waveform = "time,code,value\n0,-4,-1\n0.25,2,2\n";

} // namespace

class TestCaptureFolder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_root = std::make_unique<QTemporaryDir>();
        m_notes.clear();
    }

    void names()
    {
        const QDateTime local(QDate(2018, 2, 7), QTime(18, 33, 3));
        QCOMPARE(captureFileName(local, captured(5, 0), u"csv"_s), u"18_02_07_18_33_03_5_ch0.csv"_s);
        QCOMPARE(
            captureFileName(local, captured(12, 3, CaptureKind::Spectrum5000), u"csv"_s),
            u"18_02_07_18_33_03_12_ch3_5000.csv"_s);
        QCOMPARE(
            captureFileName(local, captured(12, 3, CaptureKind::Spectrum200), u"csv"_s),
            u"18_02_07_18_33_03_12_ch3_200.csv"_s);
    }

    void whatTheFormatSays()
    {
        CaptureFolder folder = make({{u"captureformat"_s, u"csv,wav"_s}});
        folder.save(captured(5, 1));
        folder.save(captured(5, 1, CaptureKind::Spectrum200));
        folder.save(captured(6, 1)); // nobody asked for it
        QCOMPARE(
            files(),
            (QStringList{
                u"18_02_07_18_33_03_5_ch1.csv"_s, u"18_02_07_18_33_03_5_ch1.wav"_s,
                u"18_02_07_18_33_03_5_ch1_200.csv"_s}));
        QCOMPARE(content("18_02_07_18_33_03_5_ch1.csv"), waveform);
        // 10 of 0.5 · code: |−4 + 2i| = √20
        QCOMPARE(content("18_02_07_18_33_03_5_ch1_200.csv"), QByteArray("frequency,amplitude\n0,1.11803399\n"));
        QCOMPARE(content("18_02_07_18_33_03_5_ch1.wav").size(), 44 + 2 * 4);
        QCOMPARE(m_notes, QStringList());
    }

    void onlySound()
    {
        make({{u"captureformat"_s, u"wav"_s}}).save(captured(5, 1));
        QCOMPARE(files(), QStringList{u"18_02_07_18_33_03_5_ch1.wav"_s});
    }

    void nothingIsOverwritten()
    {
        CaptureFolder folder = make({});
        folder.save(captured(5, 1));
        folder.save(captured(5, 1));
        QCOMPARE(files(), (QStringList{u"18_02_07_18_33_03_5_ch1.csv"_s, u"18_02_07_18_33_04_5_ch1.csv"_s}));
    }

    /// Told once when it begins and once when it ends; no torn file stays.
    void aFullDisk()
    {
        CaptureFolder folder = make({});
        {
            const FileSizeLimit full(10);
            folder.save(captured(5, 0));
            folder.save(captured(5, 1));
        }
        QCOMPARE(files(), QStringList());
        QCOMPARE(m_notes.size(), 1);
        QVERIFY(m_notes.first().startsWith(u"A capture of an L-VIMS is lost, it could not be saved: "_s));
        folder.save(captured(5, 2));
        folder.save(captured(5, 3));
        QCOMPARE(files().size(), 2);
        QCOMPARE(m_notes.size(), 2);
        QCOMPARE(m_notes.last(), u"The captures of the L-VIMS are being saved again."_s);
    }

    void aFolderThatCannotBeMade()
    {
        writeAll(m_root->filePath(u"Vims"_s), "a file");
        make({}).save(captured(5, 0));
        QCOMPARE(m_notes.size(), 1);
    }

    void oldOnesGo()
    {
        CaptureFolder folder = make({{u"capturekeep"_s, u"2"_s}});
        QDir(m_root->path()).mkdir(u"Vims"_s);
        for (const char *name :
             {"18_02_05_18_33_02_5_ch0.csv", "18_02_05_18_33_02_5_ch0.wav", "18_02_05_18_33_04_5_ch0.csv",
              "18_02_05_18_33_02_6_ch0.csv", "17_01_01_00_00_00_5_ch3_5000.csv", "notes.txt",
              "18_13_05_18_33_02_5_ch0.csv"}) {
            writeAll(path(name), "x");
        }
        folder.removeOld(moscow("2018-02-07T18:33:03"));
        QCOMPARE(
            files(),
            (QStringList{
                u"18_02_05_18_33_02_6_ch0.csv"_s, u"18_02_05_18_33_04_5_ch0.csv"_s, u"18_13_05_18_33_02_5_ch0.csv"_s,
                u"notes.txt"_s}));
        make({}).removeOld(moscow("2028-02-07T18:33:03")); // for ever
        QCOMPARE(files().size(), 4);
    }

    void whatAKilledRunHasLeft()
    {
        QDir(m_root->path()).mkdir(u"Vims"_s);
        writeAll(path("18_02_05_18_33_02_5_ch0.csv.aBcDeF"), "x");
        writeAll(path("18_02_05_18_33_02_5_ch0.csv"), "x");
        make({}).open();
        QCOMPARE(files(), QStringList{u"18_02_05_18_33_02_5_ch0.csv"_s});
    }

    /// Through the writer of the history, as the program does it.
    void throughTheWriter_data()
    {
        QTest::addColumn<bool>("savesFiles");
        QTest::newRow("CanSave=1") << true;
        QTest::newRow("CanSave=0") << false;
    }
    void throughTheWriter()
    {
        QFETCH(const bool, savesFiles);
        HistoryConfig config = configWith({{u"capturekeep"_s, u"1"_s}});
        config.savesFiles = savesFiles;
        config.saveInterval = 10ms;
        QDir(m_root->path()).mkdir(u"Vims"_s);
        writeAll(path("18_02_05_18_33_02_5_ch0.csv"), "x");
        HistoryWriter writer(config, [] { return moscow("2018-02-07T18:33:03"); });
        writer.start();
        writer.appendCapture(captured(5, 2));
        if (savesFiles) {
            QTRY_COMPARE(files(), QStringList{u"18_02_07_18_33_03_5_ch2.csv"_s}); // and the old one is gone
        }
        writer.stop();
        QCOMPARE(
            files(), QStringList{savesFiles ? u"18_02_07_18_33_03_5_ch2.csv"_s : u"18_02_05_18_33_02_5_ch0.csv"_s});
    }

private:
    HistoryConfig configWith(const QHash<QString, QString> &options) const
    {
        LineConfig line;
        line.index = 1;
        line.isOn = true;
        line.sensors = {vibrationModule(5), vibrationModule(6)};
        line.sensors[0].options = options;
        line.sensors[0].options.insert(u"captureevery"_s, u"10"_s);
        HistoryConfig config;
        config.folder = m_root->path();
        config.zone = moscowZone();
        config.lines = {line};
        return config;
    }
    CaptureFolder make(const QHash<QString, QString> &options)
    {
        return CaptureFolder(configWith(options), [this](JournalKind, const QString &text) { m_notes.append(text); });
    }
    QString path(const char *name) const { return m_root->filePath(u"Vims/"_s + QLatin1String(name)); }
    QByteArray content(const char *name) const { return readAll(path(name)); }
    QStringList files() const
    {
        return QDir(m_root->filePath(u"Vims"_s)).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

    std::unique_ptr<QTemporaryDir> m_root;
    QStringList m_notes;
};

QTEST_GUILESS_MAIN(TestCaptureFolder)
#include "tst_capturefolder.moc"
