#include "core/station/objectsfile.h"

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

/// Places of the fields.
enum Place : quint8 { Number, Period, Port, Speed, DataBits, Stop, Check, Extra };

std::optional<ObjectKind> kindOf(QChar letter)
{
    switch (letter.toLower().unicode()) {
    case u'x': return ObjectKind::Gathering;
    case u'w': return ObjectKind::L154;
    case u'a': return ObjectKind::Fastwel;
    case u'v': return ObjectKind::Wind;
    case u'q': return ObjectKind::Line;
    default: return {};
    }
}

/// One line of ACK.INI.
class ObjectReader
{
public:
    ObjectReader(RecordReader &reader, int line)
        : m_reader(reader)
    {
        m_object.line = line;
    }

    StationObject read()
    {
        m_object.number = m_reader.integer(Number, Station::tr("number"), {1, 255});
        m_object.period = std::chrono::seconds(m_reader.integerOrNone(Period, Station::tr("period"), {0, 86400}, 0));
        takePort();
        const bool isLine = m_object.kind == ObjectKind::Wind || m_object.kind == ObjectKind::Line;
        if (m_reader.isGood() && isLine) {
            takeLineSettings();
        }
        if (m_reader.isGood() && m_reader.size() > Extra) {
            takeExtra();
        }
        return m_object;
    }

private:
    void takePort()
    {
        const QString name = Station::tr("port");
        const QString port = m_reader.text(Port, name);
        if (!m_reader.isGood()) {
            return;
        }
        const QChar letter = port.isEmpty() ? QChar() : latinised(port.front());
        const auto kind = kindOf(letter);
        if (!kind) {
            m_reader.refuse(Port, name, whyNot(letter, port));
            return;
        }
        m_object.kind = *kind;
        takeAddress(port.mid(1), name);
    }

    static QString whyNot(QChar letter, const QString &port)
    {
        if (!letter.isNull() && QStringLiteral("rygRYG").contains(letter)) {
            return Station::tr("A port of the type “%1” cannot be used: no document says how its data look. Measure "
                               "with another source.")
                .arg(letter);
        }
        return Station::tr("%1 is no port: it begins with one of the letters x, w, a, v, q.").arg(quoted(port));
    }

    void takeAddress(const QString &address, const QString &name)
    {
        const bool needsAddress = m_object.kind == ObjectKind::Wind || m_object.kind == ObjectKind::Line;
        if (address.startsWith(u':')) {
            m_object.device = address.mid(1);
        } else if (!address.isEmpty()) {
            bool isNumber = false;
            m_object.com = address.toInt(&isNumber);
            if (needsAddress && (!isNumber || m_object.com < 1 || m_object.com > 256)) {
                m_reader.refuse(
                    Port, name, Station::tr("%1 is not the number of a port, 1 to 256.").arg(quoted(address)));
            }
        }
        if (needsAddress && address.size() <= (address.startsWith(u':') ? 1 : 0)) {
            m_reader.refuse(
                Port, name, Station::tr("The type letter has no port behind it: write its number, as in q1."));
        }
    }

    int orDefault(Place place, const QString &name, Range range, int usual)
    {
        const bool mayBeAbsent = !m_object.device.isEmpty();
        return mayBeAbsent && place >= m_reader.size() ? usual : m_reader.integerOrNone(place, name, range, usual);
    }

    void takeLineSettings()
    {
        m_object.baudRate = orDefault(Speed, Station::tr("speed"), {50, 4'000'000}, m_object.baudRate);
        m_object.dataBits = orDefault(DataBits, Station::tr("data bits"), {5, 8}, m_object.dataBits);
        takeStopBits();
        takeParity();
    }

    void takeStopBits()
    {
        const QString name = Station::tr("stop bits");
        if (!m_reader.has(Stop)) {
            orDefault(Stop, name, {1, 2}, 1);
            return;
        }
        const double bits = m_reader.number(Stop, name, {1, 2});
        if (m_reader.isGood() && bits != 1 && bits != 1.5 && bits != 2) {
            m_reader.refuse(Stop, name, Station::tr("There are 1, 1.5 or 2 stop bits."));
        }
        m_object.stopBits = bits == 2 ? StopBits::Two : bits == 1.5 ? StopBits::OneAndHalf : StopBits::One;
    }

    void takeParity()
    {
        const QString name = Station::tr("parity");
        switch (orDefault(Check, name, {0, 255}, 0)) {
        case 0: m_object.parity = Parity::None; break;
        case 1: m_object.parity = Parity::Odd; break;
        case 2: m_object.parity = Parity::Even; break;
        case 5: m_object.parity = Parity::Mark; break;
        case 7: m_object.parity = Parity::Space; break;
        default:
            m_reader.refuse(
                Check, name, Station::tr("The parity is 0 (none), 1 (odd), 2 (even), 5 (mark) or 7 (space)."));
        }
    }

    void takeExtra()
    {
        const QString name = Station::tr("extra");
        m_object.extra = m_reader.text(Extra, name);
        if (m_object.kind == ObjectKind::Wind) {
            m_object.windMultiplier = m_reader.integerOrNone(Extra, name, {1, 1000}, m_object.windMultiplier);
        }
    }

    RecordReader &m_reader;
    StationObject m_object;
};

/// What two lines cannot share; empty: nothing.
QString exclusive(const StationObject &object)
{
    if (object.kind != ObjectKind::Wind && object.kind != ObjectKind::Line) {
        return {};
    }
    return object.device.isEmpty() ? QStringLiteral("COM%1").arg(object.com) : object.device;
}

} // namespace

QList<StationObject> readObjects(const QString &file, const QByteArray &bytes, Complaints &complaints)
{
    QList<StationObject> objects;
    QHash<QString, int> taken;
    for (const Record &record : recordsOf(decodeStationText(bytes))) {
        RecordReader reader(file, record, Station::tr("The object is left out."), complaints);
        const StationObject object = ObjectReader(reader, record.line).read();
        const QString port = exclusive(object);
        if (reader.isGood() && taken.contains(port)) {
            reader.refuse(
                Port, Station::tr("port"), Station::tr("%1 is used in line %2.").arg(port).arg(taken.value(port)));
        }
        if (!reader.isGood()) {
            continue;
        }
        if (!port.isEmpty()) {
            taken.insert(port, record.line);
        }
        objects.append(object);
    }
    return objects;
}

} // namespace gorizont::station
