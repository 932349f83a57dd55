#include "core/station/boardfile.h"

#include "core/station/fieldsequence.h"
#include "core/station/recordreader.h"

#include <QCoreApplication>
#include <QHash>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

using Range = RecordReader::Range;
using LetterCounts = QHash<QChar, int>;

/// Where the values stand in the list; -1: the file has none such.
struct Layout
{
    int values;
    int divider1;
    int divider2;
    int period;
    int hardwareAverage;
    int instant;
    int gate;
    int test;
    int sendsInstant;
    int frequency;
    int analogue; ///< then come digital and order
};

constexpr Layout l154{14, 4, 5, -1, -1, 6, 7, 8, 9, 10, 11};
constexpr Layout ai16{12, -1, -1, 4, 5, 6, -1, 7, 8, -1, 9};
constexpr Layout builtIn{10, -1, -1, 2, 3, 4, -1, 5, 6, -1, 7};

constexpr double clockRate = 1e6; ///< Hz, before the dividers
constexpr Range dividers{1, 65535};

bool isUnconnected(QChar character)
{
    return QStringLiteral("-._ ").contains(character);
}

class BoardReader
{
public:
    BoardReader(const QString &file, const QList<Record> &values, const Layout &layout, Complaints &complaints)
        : m_file(file)
        , m_values(values)
        , m_layout(layout)
        , m_complaints(complaints)
    {
    }

    void read(BoardConfig &board)
    {
        takeRate(board);
        board.instantSeconds = integer(m_layout.instant, Station::tr("seconds of a current value"), {1, 3600}, 1);
        board.gate = number(m_layout.gate, Station::tr("gate, s"), {0.001, 3600}, 1);
        board.isTest = integer(m_layout.test, Station::tr("test mode"), {0, 65535}, 0) != 0;
        board.sendsInstant = integer(m_layout.sendsInstant, Station::tr("current value"), {0, 65535}, 0) != 0;
        LetterCounts counts;
        board.analogue = letters(m_layout.analogue, Station::tr("analogue inputs"), BoardConfig::mostAnalogue, counts);
        takeFrequency(board, counts);
        board.digital = letters(m_layout.analogue + 1, Station::tr("digital inputs"), BoardConfig::mostDigital, counts);
        const Field &digital = m_values.at(m_layout.analogue + 1).fields.first();
        board.digitalPlaces =
            digital.isNone() ? 0 : static_cast<int>(std::min<qsizetype>(digital.text.size(), BoardConfig::mostDigital));
        LetterCounts orderCounts;
        constexpr int longestOrder = 255;
        board.order = letters(m_layout.analogue + 2, Station::tr("order of processing"), longestOrder, orderCounts);
    }

private:
    void takeRate(BoardConfig &board)
    {
        if (m_layout.period >= 0) {
            board.switchRate =
                clockRate / number(m_layout.period, Station::tr("period of the timer, µs"), {1, 10'000'000}, 1000);
            const bool isAi16 = m_layout.values == ai16.values; // 2, 4, 8, 16 measurements, else 4, 8, 16
            const int step =
                integer(m_layout.hardwareAverage, Station::tr("averaging in the board"), {0, isAi16 ? 4.0 : 3.0}, 0);
            board.hardwareAverage = step == 0 ? 1 : 1 << (isAi16 ? step : step + 1);
            return;
        }
        const int first = integer(m_layout.divider1, Station::tr("first divider"), dividers, 1);
        const int second = integer(m_layout.divider2, Station::tr("second divider"), dividers, 1000);
        board.switchRate = clockRate / first / second;
    }

    void takeFrequency(BoardConfig &board, LetterCounts &counts)
    {
        if (m_layout.frequency < 0) {
            return;
        }
        const QList<BoardInput> inputs = letters(m_layout.frequency, Station::tr("frequency input"), 1, counts);
        if (!inputs.isEmpty()) {
            board.frequency = inputs.first().parameter;
        }
    }

    double number(int place, const QString &name, Range range, double usual)
    {
        if (place < 0) {
            return usual;
        }
        RecordReader reader(
            m_file, m_values.at(place), Station::tr("%1 is used.").arg(QString::number(usual)), m_complaints);
        const double value = reader.has(0) ? reader.number(0, name, range) : usual;
        return reader.isGood() ? value : usual;
    }

    int integer(int place, const QString &name, Range range, int usual)
    {
        RecordReader reader(
            m_file, m_values.at(place), Station::tr("%1 is used.").arg(QString::number(usual)), m_complaints);
        const int value = reader.integerOrNone(0, name, range, usual);
        return reader.isGood() ? value : usual;
    }

    /// A string of letters, each place a channel.
    QList<BoardInput> letters(int place, const QString &name, int most, LetterCounts &counts)
    {
        const Record &record = m_values.at(place);
        RecordReader reader(m_file, record, Station::tr("The other letters are used."), m_complaints);
        QList<BoardInput> inputs;
        if (!reader.has(0)) {
            return inputs;
        }
        const QString text = latinised(reader.text(0, name));
        if (text.size() > most) {
            reader.refuse(0, name, Station::tr("There are more than %1 letters.").arg(most));
        }
        for (qsizetype at = 0; at < std::min<qsizetype>(text.size(), most); ++at) {
            const QChar letter = text.at(at);
            if (parameterIdOf(QStringView(&letter, 1))) {
                inputs.append({static_cast<int>(at), {letter, ++counts[letter]}});
            } else if (!isUnconnected(letter)) {
                reader.refuse(
                    0, name,
                    Station::tr("%1 at place %2 is not a Latin letter.").arg(quoted(QString(letter))).arg(at + 1));
            }
        }
        return inputs;
    }

    const QString m_file;
    const QList<Record> &m_values;
    const Layout &m_layout;
    Complaints &m_complaints;
};

int countOf(QChar code, const BoardConfig &board)
{
    int count = board.frequency && board.frequency->code == code ? 1 : 0;
    for (const QList<BoardInput> *inputs : {&board.analogue, &board.digital}) {
        for (const BoardInput &input : *inputs) {
            count += input.parameter.code == code ? 1 : 0;
        }
    }
    return count;
}

} // namespace

std::optional<BoardConfig> readBoard(
    BoardKind kind, const QString &file, const QByteArray &bytes, Complaints &complaints)
{
    const QList<Record> records = recordsOf(decodeStationText(bytes));
    const bool isL154 = kind == BoardKind::L154;
    const bool isShort = !isL154 && records.size() < ai16.values;
    const QList<Record> values = valuesOf(records, isL154 ? l154.values : isShort ? builtIn.values : ai16.values);
    const bool isBuiltIn = !isL154 && values.size() == builtIn.values;
    const Layout &layout = isL154 ? l154 : isBuiltIn ? builtIn : ai16;
    if (values.size() < layout.values) {
        const QString expected = isL154 ? QStringLiteral("14") : Station::tr("12, or 10 without the AI16-5A");
        complaints.add(
            {file,
             0,
             0,
             {},
             Station::tr("The file has %1 values instead of %2.").arg(values.size()).arg(expected),
             Station::tr("The board is left out.")});
        return {};
    }
    BoardConfig board;
    board.kind = kind;
    BoardReader(file, values, layout, complaints).read(board);
    return board;
}

void countOn(BoardConfig &board, const BoardConfig &first)
{
    constexpr int ownBits = 8; // that each board had
    board.firstBit = std::max(ownBits, first.digitalPlaces);
    for (QList<BoardInput> *inputs : {&board.analogue, &board.digital, &board.order}) {
        for (BoardInput &input : *inputs) {
            input.parameter.number += countOf(input.parameter.code, first);
        }
    }
}

} // namespace gorizont::station
