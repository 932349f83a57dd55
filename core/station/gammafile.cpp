#include "core/station/gammafile.h"

#include "core/station/fieldsequence.h"
#include "core/station/recordreader.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

constexpr qsizetype valueCount = 7;

class GammaReader
{
public:
    GammaReader(const QString &file, const QList<Record> &values, Complaints &complaints)
        : m_file(file)
        , m_values(values)
        , m_complaints(complaints)
    {
    }

    std::optional<GammaConfig> read()
    {
        GammaConfig gamma;
        takeParameter(gamma);
        gamma.gate = std::chrono::seconds(integer(1, Station::tr("gate, s"), {1, 3600}));
        gamma.inputBit = integer(2, Station::tr("input bit"), {0, 31});
        gamma.blinkerBit = integer(3, Station::tr("output bit of the blinker"), {0, 31});
        gamma.checkAt = std::chrono::minutes(integer(4, Station::tr("minute of the check"), {0, 24 * 60 - 1}));
        gamma.sensitivity = number(5, Station::tr("sensitivity"), {0, 1e12});
        gamma.background = number(6, Station::tr("background"), {0, 1e12});
        return m_isGood ? std::optional(gamma) : std::nullopt;
    }

private:
    void takeParameter(GammaConfig &gamma)
    {
        RecordReader reader = readerAt(0);
        const QString text = reader.field(0).text;
        const auto id = parameterIdOf(text);
        if (!id) {
            reader.refuse(
                0, Station::tr("code"),
                Station::tr("%1 is not a code: a Latin letter, with a number if need be.").arg(quoted(text)));
        }
        gamma.parameter = id.value_or(ParameterId{});
        m_isGood = m_isGood && reader.isGood();
    }

    int integer(qsizetype place, const QString &name, RecordReader::Range range)
    {
        RecordReader reader = readerAt(place);
        const int value = reader.integer(0, name, range);
        m_isGood = m_isGood && reader.isGood();
        return value;
    }

    double number(qsizetype place, const QString &name, RecordReader::Range range)
    {
        RecordReader reader = readerAt(place);
        const double value = reader.number(0, name, range);
        m_isGood = m_isGood && reader.isGood();
        return value;
    }

    RecordReader readerAt(qsizetype place)
    {
        return {m_file, m_values.at(place), Station::tr("The gamma sensor is left out."), m_complaints};
    }

    const QString m_file;
    const QList<Record> &m_values;
    Complaints &m_complaints;
    bool m_isGood = true;
};

} // namespace

std::optional<GammaConfig> readGamma(const QString &file, const QByteArray &bytes, Complaints &complaints)
{
    const QList<Record> values = valuesOf(recordsOf(decodeStationText(bytes)), valueCount);
    if (values.size() < valueCount) {
        complaints.add(
            {file,
             0,
             0,
             {},
             Station::tr("The file has %1 values instead of %2.").arg(values.size()).arg(valueCount),
             Station::tr("The gamma sensor is left out.")});
        return {};
    }
    return GammaReader(file, values, complaints).read();
}

} // namespace gorizont::station
