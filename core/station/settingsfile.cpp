#include "core/station/settingsfile.h"

#include "core/station/fieldsequence.h"
#include "core/station/recordreader.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

using Range = RecordReader::Range;
using std::chrono::microseconds;
using std::chrono::seconds;

constexpr int day = 86400; ///< s
constexpr int lastValue = 33;

/// Takes the values of ACK.PSE by their places in the manual's list, 1…33.
class SettingsReader
{
public:
    SettingsReader(const QString &file, const QList<Record> &records, Complaints &complaints)
        : m_file(file)
        , m_records(records)
        , m_complaints(complaints)
    {
    }

    void take(int place, const QString &name, Range range, int &value)
    {
        takeWith(place, value, [range, &name](RecordReader &reader) { return reader.integer(0, name, range); });
    }

    void take(int place, const QString &name, Range range, double &value)
    {
        takeWith(place, value, [range, &name](RecordReader &reader) { return reader.number(0, name, range); });
    }

    void take(int place, const QString &name, bool &value)
    {
        takeWith(place, value, [&name](RecordReader &reader) { return reader.flag(0, name); });
    }

    template <typename Rep, typename Period>
    void take(int place, const QString &name, Range range, std::chrono::duration<Rep, Period> &value)
    {
        int count = static_cast<int>(value.count());
        take(place, name, range, count);
        value = std::chrono::duration<Rep, Period>(count);
    }

    void tellAbsent() const
    {
        if (m_records.size() < lastValue) {
            m_complaints.add(
                {m_file,
                 0,
                 0,
                 {},
                 Station::tr("The file has %1 of %2 values.").arg(m_records.size()).arg(lastValue),
                 Station::tr("The usual ones are used for the others.")});
        }
    }

private:
    template <typename Value, typename Take> void takeWith(int place, Value &value, const Take &takeFrom)
    {
        if (place > m_records.size()) {
            return;
        }
        RecordReader reader(
            m_file, m_records.at(place - 1), Station::tr("%1 is used.").arg(QString::number(double(value))),
            m_complaints);
        if (!reader.has(0)) {
            return;
        }
        const Value taken = takeFrom(reader);
        if (reader.isGood()) {
            value = taken;
        }
    }

    const QString m_file;
    const QList<Record> &m_records;
    Complaints &m_complaints;
};

/// Places of what has no effect: modem, radio, queues, sound and screen.
QString withoutEffect(qsizetype values)
{
    constexpr int places[] = {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 17, 18, 19, 20, 25, 27};
    QStringList shown;
    for (const int place : places) {
        if (place <= values) {
            shown.append(QString::number(place));
        }
    }
    return shown.join(QStringLiteral(", "));
}

} // namespace

StationSettings readSettings(const QString &file, const QByteArray &bytes, Complaints &complaints)
{
    const QList<Record> records = valuesOf(recordsOf(decodeStationText(bytes)), 1);
    SettingsReader reader(file, records, complaints);
    StationSettings settings;
    reader.take(1, Station::tr("number of the station"), {1, 255}, settings.number);
    reader.take(2, Station::tr("calculation of σ"), settings.hasDeviation);
    reader.take(13, Station::tr("hold of the maximum, ticks"), {0, 10'000'000}, settings.maximumHold);
    reader.take(21, Station::tr("shift of the request, s"), {-day, day}, settings.requestShift);
    reader.take(22, Station::tr("copies in SAFE"), settings.keepsSafeCopies);
    reader.take(23, Station::tr("number of attempts"), {1, 1000}, settings.attempts);
    reader.take(24, Station::tr("averaging of frequency, ticks"), {1, 65535}, settings.frequencyTicks);
    reader.take(26, Station::tr("calibration time, s"), {0, day}, settings.calibration);
    reader.take(28, Station::tr("averaging, s"), {1, day}, settings.averaging);
    reader.take(29, Station::tr("percent of good values"), {0, 99.9}, settings.goodPercent);
    reader.take(30, Station::tr("no protocol file"), settings.isProtocolOff);
    reader.take(31, Station::tr("watchdog, s"), {0, day}, settings.watchdog);
    reader.take(32, Station::tr("test mode"), settings.isTest);
    reader.take(33, Station::tr("pulse filter, µs"), {0, 1'000'000}, settings.pulseFilter);
    reader.tellAbsent();
    const QString idle = withoutEffect(records.size());
    if (!idle.isEmpty()) {
        complaints.add({file, 0, 0, {}, Station::tr("The values %1 are without effect here.").arg(idle), {}});
    }
    return settings;
}

} // namespace gorizont::station
