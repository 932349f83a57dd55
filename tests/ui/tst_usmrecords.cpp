#include "tests/ui/usmdialogbench.h"

#include <QFileDialog>
#include <QSemaphore>
#include <QTemporaryDir>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using usmisn::Simulator;

namespace {

const QList<SensorConfig> one{usm(1, 5, 7)};

} // namespace

/// The records in the service window of УСМ-ИСН, and what of them comes to the archive.
class TestUsmRecords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_kept.clear(); }
    void cleanup() { m.reset(); }

    /// A month of a recorder, started and woken as a user does it.
    void aMonthOfARecorder()
    {
        open();
        m->button("startCycle")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("it records and sleeps")), patience);
        m->bench.skip(std::chrono::hours(24 * 30));
        m->button("stopCycle")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->button("downloadAll")->isEnabled(), patience);
        const int stored = size();
        QVERIFY2(stored >= 2 * 719, qPrintable(QString::number(stored)));

        m->button("downloadNew")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("new record(s)")), patience);
        QCOMPARE(m->text("recordCount"), QString::number(stored));
        QCOMPARE(m->text("recordsMissing"), QStringLiteral("0"));
        QCOMPARE(names().size(), stored);
        QCOMPARE(distinctNames(), stored);
        const DeviceRecords &last = m_kept.constLast();
        QCOMPARE(last.source, QStringLiteral("УСМ-ИСН 00003595"));
        QCOMPARE(last.readings.size(), stored / 2);
        QVERIFY(last.readings.constLast().time - last.readings.constFirst().time >= 718h);
        for (const DeviceRecords &batch : m_kept) {
            QCOMPARE(batch.number, 5);
        }

        m->button("downloadNew")->click(); // they count as read
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral(": 0 new record(s)")), patience);
        m->button("downloadAll")->click(); // and are known
        QTRY_VERIFY_WITH_TIMEOUT(m->button("downloadAll")->isEnabled(), patience);
        QCOMPARE(m->text("recordCount"), QString::number(stored));
        QCOMPARE(names().size(), stored);
    }

    /// The adapter is pulled out; what New will not send again comes with All, each record once.
    void aBrokenDownloadGoesOn()
    {
        openHeld();
        m_mayGoOn.release(2);
        m->button("downloadAll")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->text("recordCount"), QStringLiteral("2"), patience);
        storeTwo();
        m_isAsked.acquire(2);
        m->button("downloadNew")->click();
        m_isAsked.acquire();
        m->bench.isPlugged = false;
        m_mayGoOn.release();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("the download broke off")), patience);
        QVERIFY(!m->button("downloadNew")->isEnabled());
        m->bench.isPlugged = true;
        QTRY_COMPARE_WITH_TIMEOUT(m->bench.state(), LineState::Open, patience);
        m->button("portButton")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->button("downloadNew")->isEnabled(), patience);
        m->bench.forgetSent();
        m_mayGoOn.release(10);
        m->button("downloadNew")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->text("recordCount"), QStringLiteral("4"), patience);
        QVERIFY(m->wasSent("GetRecord/0,ALL,1") && !m->wasSent("NEW"));
        QCOMPARE(names().size(), 4);
        QCOMPARE(distinctNames(), 4);
    }

    void aStoppedDownloadAsksForAllTheNextTime()
    {
        openHeld();
        m->button("downloadNew")->click();
        m_isAsked.acquire();
        QVERIFY(!m->button("downloadAll")->isEnabled());
        m->button("stopDownload")->click();
        m_mayGoOn.release();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("the download was stopped")), patience);
        QCOMPARE(m->text("recordCount"), QStringLiteral("0"));
        m->bench.forgetSent();
        m_mayGoOn.release(10);
        m->button("downloadNew")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->text("recordCount"), QStringLiteral("2"), patience);
        QVERIFY(m->wasSent("GetRecord/0,ALL,1"));
        QVERIFY(!m->wasSent("NEW"));
    }

    /// A download holds its line and no other.
    void otherLinesArePolledMeanwhile()
    {
        const QList<SensorConfig> neighbours{usm(1, 6, 7)};
        ServiceBench other(serviceLine(neighbours), neighbours);
        openHeld();
        m->button("downloadAll")->click();
        m_isAsked.acquire();
        for (int turn = 0; turn < 3; ++turn) {
            other.forgetAnswers();
            QTRY_VERIFY_WITH_TIMEOUT(other.isPolled(), patience);
        }
        QCOMPARE(m->text("recordCount"), QStringLiteral("0"));
        m_mayGoOn.release(2);
        QTRY_COMPARE_WITH_TIMEOUT(m->text("recordCount"), QStringLiteral("2"), patience);
    }

    /// Polling goes on, however much the device would still send.
    void leavingBreaksTheDownloadOff()
    {
        openHeld();
        m->button("downloadNew")->click();
        m_isAsked.acquire();
        m->dialog->reject();
        QVERIFY(m->question().startsWith(QStringLiteral("Records are still being downloaded.")));
        m->answer(false);
        QVERIFY(m->dialog->isVisible());
        m->dialog->reject();
        m->button("questionGo")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m->dialog, patience);
        m->bench.forgetAnswers();
        m_mayGoOn.release(10);
        QTRY_VERIFY_WITH_TIMEOUT(m->bench.isPolled(), patience);
    }

    void savesATable()
    {
        openWithTwo();
        m->button("downloadAll")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->button("saveRecords")->isEnabled(), patience);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("2 new record(s)")), patience);
        const QTemporaryDir folder;
        save(folder.filePath(QStringLiteral("there/is/none.csv")));
        QVERIFY2(m->message().startsWith(QStringLiteral("The records were not saved (")), qPrintable(m->message()));
        const QString path = folder.filePath(QStringLiteral("records.csv"));
        save(path);
        QCOMPARE(m->message(), QStringLiteral("2 record(s) saved"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().split('\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines.at(0), QByteArray("time,timestamp,serial,channel,measurement,value,variation,temperature\r"));
        QVERIFY(lines.at(1).contains(",00003595,1,1,") && lines.at(2).contains(",00003595,2,2,"));
    }

    void keepsOnlyWhatTheSiteMeasures_data()
    {
        QTest::addColumn<QString>("serial"); ///< in the ini
        QTest::addColumn<int>("address"); ///< in the ini
        QTest::addColumn<QString>("sentence");
        QTest::addColumn<int>("kept");
        const QString strange =
            QStringLiteral("keeps nothing of it: the configuration file expects 01234567 at this address (SND31)");
        const QString nobody =
            QStringLiteral("keeps nothing of it: no sensor of the configuration file has this address");
        const QString good = QStringLiteral("keeps each record once, for sensor N 5");
        QTest::newRow("the one of the ini") << QStringLiteral("3595") << 7 << good << 2;
        QTest::newRow("without a number") << QStringLiteral("no. 3595") << 7 << good << 2;
        QTest::newRow("another device") << QStringLiteral("01234567") << 7 << strange << 0;
        QTest::newRow("at no address of the ini") << QStringLiteral("3595") << 8 << nobody << 0;
    }
    void keepsOnlyWhatTheSiteMeasures()
    {
        QFETCH(QString, serial);
        QFETCH(int, address);
        QFETCH(QString, sentence);
        QFETCH(int, kept);
        SensorConfig sensor = one.first();
        sensor.serialNumber = serial;
        sensor.address = address;
        m = std::make_unique<UsmDialogBench>(QList<SensorConfig>{sensor}, one);
        m->open([this](const DeviceRecords &records) { m_kept.append(records); });
        QCOMPARE(m->text("recordsArchive"), sentence);
        storeTwo();
        m->button("downloadAll")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("2 new record(s)")), patience);
        QCOMPARE(m->text("recordCount"), QStringLiteral("2"));
        QCOMPARE(names().size(), kept);
    }

    void saysThatNobodyKeepsThem()
    {
        m = std::make_unique<UsmDialogBench>(one, one);
        m->open();
        QCOMPARE(m->text("recordsArchive"), QStringLiteral("is not written here; save the records as CSV"));
    }

private:
    void open(const BenchOptions &options = {})
    {
        m = std::make_unique<UsmDialogBench>(one, one, options);
        m->open([this](const DeviceRecords &records) { m_kept.append(records); });
    }
    void openWithTwo()
    {
        open();
        storeTwo();
    }
    /// Two records, one of each channel; the device is asked for them when m_mayGoOn says so.
    void openHeld()
    {
        m_isAsked.tryAcquire(m_isAsked.available());
        m_mayGoOn.tryAcquire(m_mayGoOn.available());
        open({.onRequest = [this](const QByteArray &request) {
            if (request.contains("GetRecord")) {
                m_isAsked.release();
                m_mayGoOn.acquire();
            }
        }});
        storeTwo();
    }
    void storeTwo()
    {
        m->find<QAbstractButton>("storeValue")->setChecked(true);
        m->button("measure")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->message(), QStringLiteral("The device keeps what it measured."), patience);
        QTRY_VERIFY_WITH_TIMEOUT(m->button("downloadAll")->isEnabled(), patience);
    }
    void save(const QString &path)
    {
        m->button("saveRecords")->click();
        auto *files = m->dialog->findChild<QFileDialog *>(QStringLiteral("recordsFileDialog"));
        QVERIFY(files);
        Q_EMIT files->fileSelected(path);
        files->close();
        QTRY_VERIFY_WITH_TIMEOUT(!m->dialog->findChild<QFileDialog *>(QStringLiteral("recordsFileDialog")), patience);
    }
    int size()
    {
        return m->bench.device<Simulator>(0, [](const Simulator &device) {
            return static_cast<int>(device.memory().size());
        });
    }
    /// Of all records that came to the archive, as often as they came.
    QStringList names() const
    {
        QStringList list;
        for (const DeviceRecords &batch : m_kept) {
            for (const DeviceRecord &record : batch.records) {
                list += record.name;
            }
        }
        return list;
    }

    qsizetype distinctNames() const
    {
        const QStringList list = names();
        return QSet<QString>(list.begin(), list.end()).size();
    }

    QList<DeviceRecords> m_kept;
    QSemaphore m_isAsked;
    QSemaphore m_mayGoOn;
    std::unique_ptr<UsmDialogBench> m;
};

QTEST_MAIN(TestUsmRecords)
#include "tst_usmrecords.moc"
