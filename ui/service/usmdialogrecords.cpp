// The records of the device in the service window of УСМ-ИСН.

#include "core/files/wholefile.h"
#include "ui/service/recordstream.h"
#include "ui/service/servicetext.h"
#include "ui/service/usmdialog.h"
#include "ui/service/usmform.h"
#include "ui/service/usmrecordspanel.h"
#include "ui/service/usmtext.h"

#include <QFileDialog>
#include <QTimer>

#include <algorithm>

namespace gorizont {

using namespace usmisn;

namespace {

const SensorConfig *sensorAt(const LineConfig &line, int address)
{
    const auto sensor = std::find_if(line.sensors.begin(), line.sensors.end(), [address](const SensorConfig &one) {
        return one.type == SensorType::UsmIsn && one.address == address;
    });
    return sensor == line.sensors.end() ? nullptr : &*sensor;
}

/// An ini without a number in SND3 takes whatever stands at the address.
bool isMeant(const SensorConfig &sensor, quint32 serial)
{
    bool isNumber = false;
    const quint32 wanted = sensor.serialNumber.toUInt(&isNumber);
    return !isNumber || wanted == serial;
}

} // namespace

/// The archive keeps only what a sensor of the site measured.
void UsmDialog::findArchive()
{
    if (m_identity->serial != m_bookSerial) {
        m_book.clear();
        m_bookSerial = m_identity->serial;
        m_isBroken = false;
        m_form->records()->showBook(m_book);
    }
    const SensorConfig *sensor = sensorAt(port().line, address());
    m_archived.reset();
    QString text;
    if (!port().keep) {
        text = tr("is not written here; save the records as CSV");
    } else if (!sensor) {
        text = tr("keeps nothing of it: no sensor of the configuration file has this address");
    } else if (!isMeant(*sensor, m_identity->serial)) {
        text = tr("keeps nothing of it: the configuration file expects %1 at this address (SND3%2)")
                   .arg(sensor->serialNumber)
                   .arg(sensor->index);
    } else {
        m_archived = *sensor;
        text = tr("keeps each record once, for sensor N %1").arg(sensor->number);
    }
    m_form->records()->showArchive(text);
}

void UsmDialog::download(RecordMask mask)
{
    if (!begin(Task::Download)) {
        return;
    }
    m_fetch.emplace(m_isBroken ? RecordMask::All : mask);
    m_stream = std::make_shared<RecordStream>();
    m_sizeBefore = m_book.size();
    m_isBroken = true; // until the end is reached
    m_drain->start();
    transferNext();
}

void UsmDialog::transferNext()
{
    say(tr("Downloading records, channel %1…").arg(m_fetch->channel() == channelX ? u'X' : u'Y'),
        m_fetch->isAgain() ? tr("The transfer broke off; it goes on with all records, those known are passed over.")
                           : QString());
    updateControls();
    run(
        [service = m_service, to = address(), mask = m_fetch->mask(), channel = m_fetch->channel(),
         stream = m_stream](Line &line) {
            return service.records(line, to, 0, mask, channel, [stream](const Value &record) {
                return stream->put(record);
            });
        },
        [this](const Result<void> &done) {
            takeRecords();
            m_fetch->record(done);
            if (m_fetch->isOver()) {
                endDownload();
            } else {
                transferNext();
            }
        });
}

/// What has come so far is kept at once: a device does not send it as New again.
void UsmDialog::takeRecords()
{
    const int number = m_archived ? m_archived->number : 0;
    DeviceRecords fresh{number, {}, {}, {}}; // what gaps they fill is known when both axes are here
    for (const Value &record : m_stream->take()) {
        if (m_book.add(record)) {
            fresh.records.append(deviceRecord(record, number));
        }
    }
    if (!fresh.records.isEmpty()) {
        m_form->records()->showBook(m_book);
        if (m_archived) {
            port().keep(fresh);
        }
    }
}

void UsmDialog::endDownload()
{
    m_drain->stop();
    const Result<void> result = m_fetch->result();
    m_isBroken = !result;
    if (m_archived) {
        const QString source = servicetext::deviceName(SensorType::UsmIsn) + u' ' + usmtext::serial(m_bookSerial);
        port().keep({m_archived->number, source, {}, readingsOf(m_book.records(), *m_archived)});
    }
    const QString text = downloadText(result);
    note(result ? JournalKind::Info : JournalKind::Error, address(), text);
    m_fetch.reset();
    m_stream.reset();
    end();
    say(tr("Sensor %1: %2").arg(address()).arg(text));
}

QString UsmDialog::downloadText(const Result<void> &result) const
{
    const int fresh = static_cast<int>(m_book.size() - m_sizeBefore);
    const QString count = tr("%n new record(s)", nullptr, fresh);
    if (result) {
        return count;
    }
    switch (result.fault()) {
    case Fault::Cancelled:
        return tr("%1; the download was stopped. The device may go on sending for some minutes; the next download asks "
                  "for "
                  "all records.")
            .arg(count);
    case Fault::Refused: return tr("%1; the device does not understand the request for its records.").arg(count);
    default: break;
    }
    return tr("%1; the download broke off (%2). The next one asks for all records and goes on with those missing.")
        .arg(count, servicetext::fault(result.fault()));
}

/// Returns at once; the file is written when a name has been chosen.
void UsmDialog::saveRecords()
{
    auto *dialog = new QFileDialog(this, tr("Save the records"));
    dialog->setObjectName(QStringLiteral("recordsFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(QStringLiteral("*.csv"));
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->selectFile(usmtext::serial(m_bookSerial) + QStringLiteral(".csv"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        QByteArray bytes = csv::header();
        for (const Value &record : m_book.records()) {
            bytes += csv::line(record);
        }
        const QString error = writeWholeFile(path, bytes);
        say(error.isEmpty() ? tr("%n record(s) saved", nullptr, static_cast<int>(m_book.size()))
                            : tr("The records were not saved (%1). Choose another folder.").arg(error));
    });
    dialog->open();
}

} // namespace gorizont
