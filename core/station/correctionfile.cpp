#include "core/station/correctionfile.h"

#include "core/station/recordreader.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

constexpr RecordReader::Range anyKey{-1e30, 1e30};

/// The lines of one file, one by one.
class CorrectionReader
{
public:
    CorrectionReader(CorrectionKind kind, Corrections &corrections)
        : m_kind(kind)
        , m_corrections(corrections)
    {
    }

    void take(RecordReader &reader, bool isFirst)
    {
        const QString start = latinised(reader.field(0).text);
        if (start.startsWith(u'~')) {
            takeThermometer(reader, start.mid(1), isFirst);
        } else if (m_kind == CorrectionKind::Real && !start.isEmpty() && start.front().isLetter()) {
            takeCoefficient(reader, start);
        } else {
            takeRow(reader);
        }
    }

    /// Rows c0, c1, … in their order; those between that are not given are 0.
    void finish()
    {
        while (!m_byTemperature.isEmpty() && m_byTemperature.last().isEmpty()) {
            m_byTemperature.removeLast();
        }
        m_corrections.real.byTemperature += m_byTemperature;
    }

private:
    CorrectionTable &table()
    {
        switch (m_kind) {
        case CorrectionKind::Input: return m_corrections.input;
        case CorrectionKind::Meteo: return m_corrections.meteo;
        case CorrectionKind::Correct: return m_corrections.correct;
        case CorrectionKind::Real: break;
        }
        return m_corrections.real.table;
    }

    void takeThermometer(RecordReader &reader, const QString &text, bool isFirst)
    {
        const QString name = Station::tr("thermometer");
        const auto id = parameterIdOf(text);
        if (m_kind != CorrectionKind::Input) {
            reader.refuse(0, name, Station::tr("Only a file INPUT names its thermometer."));
        } else if (!isFirst) {
            reader.refuse(0, name, Station::tr("The thermometer is named in the first line only."));
        } else if (!id) {
            reader.refuse(0, name, Station::tr("%1 is not a code and a number, as in ~f01.").arg(quoted(u'~' + text)));
        } else {
            m_corrections.inputThermometer = id;
        }
    }

    void takeRow(RecordReader &reader)
    {
        const QString name =
            m_kind == CorrectionKind::Correct ? Station::tr("measured value") : Station::tr("temperature");
        CorrectionTable::Row row;
        row.below = reader.number(0, name, anyKey);
        row.coefficients = reader.coefficients(1, Station::tr("polynomial"));
        QList<CorrectionTable::Row> &rows = table().rows;
        if (!m_byTemperature.isEmpty()) {
            reader.refuse(0, name, mixed());
        } else if (!rows.isEmpty() && row.below <= rows.last().below) {
            reader.refuse(0, name, Station::tr("The value is not greater than the one in the line before."));
        }
        if (reader.isGood()) {
            rows.append(row);
        }
    }

    void takeCoefficient(RecordReader &reader, const QString &start)
    {
        const QString name = Station::tr("coefficient");
        const bool isNamed = start.size() == 2 && start.front().toLower() == u'c' && start.back().isDigit();
        const int index = start.back().digitValue();
        const QList<double> coefficients = reader.coefficients(1, Station::tr("polynomial"));
        if (!isNamed) {
            reader.refuse(0, name, Station::tr("%1 is not one of c0 … c9.").arg(quoted(start)));
        } else if (!m_corrections.real.table.isEmpty()) {
            reader.refuse(0, name, mixed());
        } else if (coefficients.isEmpty()) {
            reader.refuse(1, Station::tr("polynomial"), Station::tr("The polynomial has no coefficients."));
        } else if (index < m_byTemperature.size() && !m_byTemperature.at(index).isEmpty()) {
            reader.refuse(0, name, Station::tr("%1 stands in the file twice.").arg(start));
        }
        if (reader.isGood()) {
            m_byTemperature.resize(std::max<qsizetype>(m_byTemperature.size(), index + 1));
            m_byTemperature[index] = coefficients;
        }
    }

    static QString mixed()
    {
        return Station::tr("Lines with a temperature and lines with c0, c1, … cannot stand in one file.");
    }

    const CorrectionKind m_kind;
    Corrections &m_corrections;
    QList<QList<double>> m_byTemperature;
};

} // namespace

void readCorrection(
    CorrectionKind kind, const QString &file, const QByteArray &bytes, Corrections &corrections, Complaints &complaints)
{
    CorrectionReader lines(kind, corrections);
    bool isFirst = true;
    for (const Record &record : recordsOf(decodeStationText(bytes))) {
        RecordReader reader(file, record, Station::tr("The parameter gets no values."), complaints);
        lines.take(reader, isFirst);
        corrections.isFaulty = corrections.isFaulty || !reader.isGood();
        isFirst = false;
    }
    lines.finish();
}

} // namespace gorizont::station
