#include "app/tool/exportoptions.h"

#include "app/tool/text.h"
#include "core/export/exportnames.h"

#include <QCommandLineParser>
#include <QDateTime>
#include <QRegularExpression>

#include <algorithm>

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;

QStringList exportedKeys()
{
    QStringList keys;
    for (const Quantity quantity : readingQuantities() + QList{Quantity::SampleX, Quantity::SampleY}) {
        keys << exportname::key(quantity);
    }
    return keys;
}

/// Reads the options one after the other and keeps the first thing that is wrong.
class Reader
{
public:
    Reader(const QCommandLineParser &parser, const ExportSite &site)
        : m_parser(parser)
        , m_site(site)
    {
    }

    std::variant<ExportRequest, QString> read()
    {
        if (!m_parser.positionalArguments().isEmpty()) {
            complain(Text::tr("after %1 comes %2").arg(u"export"_s, Text::tr("nothing")));
        }
        m_request.zone = m_site.zone;
        m_request.format = choice(
            u"format"_s, {u"csv-ru"_s, u"csv-iso"_s, u"mseed"_s},
            {ExportFormat::CsvRussian, ExportFormat::CsvIso, ExportFormat::MiniSeed});
        m_request.every = choice(
            u"every"_s, {u"raw"_s, u"minute"_s, u"hour"_s, u"day"_s},
            {ExportEvery::Reading, ExportEvery::Minute, ExportEvery::Hour, ExportEvery::Day});
        m_request.from = time(u"from"_s, 0);
        m_request.to = time(u"to"_s, 1);
        readSensors();
        readQuantities();
        readCodes();
        m_request.path = m_parser.value(u"out"_s);
        if (m_request.path.isEmpty()) {
            complain(Text::tr("--%1 is missing").arg(u"out"_s));
        }
        if (!m_problem.isEmpty()) {
            return m_problem;
        }
        return m_request;
    }

private:
    void complain(const QString &problem)
    {
        if (m_problem.isEmpty()) {
            m_problem = problem;
        }
    }
    void complainOf(const QString &option, const QString &range)
    {
        complain(Text::tr("--%1 takes %2, not \"%3\"").arg(option, range, m_parser.value(option)));
    }

    /// The first of \a values if the option is not there.
    template <typename T> T choice(const QString &option, const QStringList &names, std::initializer_list<T> values)
    {
        const qsizetype at = m_parser.isSet(option) ? names.indexOf(m_parser.value(option).toLower()) : 0;
        if (at < 0) {
            complainOf(option, names.join(u", "_s));
        }
        return values.begin()[std::max(at, qsizetype(0))];
    }

    /// A day alone is its beginning \a daysLater.
    UtcTime time(const QString &option, int daysLater)
    {
        const QString text = m_parser.value(option).trimmed();
        if (text.isEmpty()) {
            complain(Text::tr("--%1 is missing").arg(option));
            return {};
        }
        for (const QString &format : {u"yyyy-MM-dd"_s, u"dd.MM.yyyy"_s}) {
            if (const QDate day = QDate::fromString(text, format); day.isValid()) {
                return utc(day.addDays(daysLater).startOfDay());
            }
        }
        QDateTime moment = QDateTime::fromString(text, Qt::ISODateWithMs);
        for (const QString &format : {u"dd.MM.yyyy HH:mm"_s, u"dd.MM.yyyy HH:mm:ss"_s, u"dd.MM.yyyy HH:mm:ss.zzz"_s}) {
            moment = moment.isValid() ? moment : QDateTime::fromString(text, format);
        }
        if (!moment.isValid()) {
            complainOf(option, Text::tr("a day (2018-02-07) or a moment (2018-02-07T18:33:03)"));
        }
        return utc(moment);
    }

    /// A time that names no zone is one of the site.
    UtcTime utc(QDateTime moment) const
    {
        if (moment.timeSpec() == Qt::LocalTime && m_site.zone.isValid()) {
            moment = QDateTime(moment.date(), moment.time(), m_site.zone);
        }
        return UtcTime(std::chrono::milliseconds(moment.toMSecsSinceEpoch()));
    }

    void readSensors()
    {
        const QString text = m_parser.value(u"sensors"_s);
        if (text.isEmpty() || text == u"all") {
            m_request.sensors = m_site.sensors;
            return;
        }
        for (const QString &part : text.split(u',')) {
            static const QRegularExpression range(u"^([0-9]{1,9})(?:-([0-9]{1,9}))?$"_s);
            const auto match = range.match(part.trimmed());
            if (!match.hasMatch()) {
                return complainOf(u"sensors"_s, Text::tr("numbers and ranges of them (1,3,5-8), or all"));
            }
            const int first = match.captured(1).toInt();
            addSensors(first, match.captured(2).isEmpty() ? first : match.captured(2).toInt());
        }
    }

    void addSensors(int first, int last)
    {
        bool isThere = false;
        for (const SensorConfig &sensor : m_site.sensors) {
            if (sensor.number >= first && sensor.number <= last) {
                isThere = true;
                if (!m_request.sensors.contains(sensor)) {
                    m_request.sensors << sensor;
                }
            }
        }
        if (!isThere) {
            complain(Text::tr("the site has no sensor %1").arg(first));
        }
    }

    void readQuantities()
    {
        const QString text = m_parser.value(u"quantities"_s);
        if (text.isEmpty() || text == u"all") {
            m_request.quantities = readingQuantities();
            return;
        }
        for (const QString &part : text.split(u',')) {
            const auto quantity = exportname::quantityOfKey(part.trimmed().toLower());
            if (!quantity) {
                return complainOf(u"quantities"_s, exportedKeys().join(u", "_s) + u", all"_s);
            }
            m_request.quantities << *quantity;
        }
    }

    void readCodes()
    {
        m_request.seed.station = seedStation(m_site.name);
        if (m_parser.isSet(u"network"_s)) {
            m_request.seed.network = m_parser.value(u"network"_s).toUpper();
        }
        if (m_parser.isSet(u"station"_s)) {
            m_request.seed.station = m_parser.value(u"station"_s).toUpper();
        }
        if (m_parser.isSet(u"channels"_s)) {
            const QStringList channels = m_parser.value(u"channels"_s).toUpper().split(u',');
            if (channels.size() != 2) {
                return complainOf(u"channels"_s, u"BN1,BN2"_s);
            }
            m_request.seed.channelX = channels.first();
            m_request.seed.channelY = channels.last();
        }
    }

    const QCommandLineParser &m_parser;
    const ExportSite &m_site;
    ExportRequest m_request;
    QString m_problem;
};

} // namespace

void describeExport(QCommandLineParser &parser)
{
    const auto add = [&parser](const QString &name, const QString &text, const QString &value) {
        parser.addOption(QCommandLineOption(name, text, value));
    };
    parser.setApplicationDescription(
        Text::tr("Writes what the archive of a site holds into a file.") + u"\n\n"_s + Text::tr("Quantities:") + u' '
        + exportedKeys().join(u", "_s) + u"\n\n"_s + Text::tr("Examples:")
        + u"\n  gorizont-tool export --from 2018-02-01 --to 2018-02-07 --sensors 1,3,5-8 --every hour --out week.csv"
          "\n  gorizont-tool export --from 2018-02-07T18:00 --to 2018-02-07T19:00 --format mseed --out quake.mseed"_s);
    parser.addPositionalArgument(u"export"_s, {}, u"export"_s);
    add(u"config"_s, Text::tr("The ini of the site."), u"FILE"_s);
    add(u"from"_s, Text::tr("The beginning, a day or a moment; without a zone it is local time."), u"TIME"_s);
    add(u"to"_s, Text::tr("The end, not included; a day alone: its end."), u"TIME"_s);
    add(u"sensors"_s, Text::tr("Numbers of sensors, as 1,3,5-8; all if not given."), u"N,…"_s);
    add(u"quantities"_s, Text::tr("As tilt-x,temperature; all but samples if not given."), u"NAME,…"_s);
    add(u"format"_s, Text::tr("csv-ru if not given."), u"csv-ru|csv-iso|mseed"_s);
    add(u"every"_s, Text::tr("A row for each reading, minute, hour or day; raw if not given."),
        u"raw|minute|hour|day"_s);
    add(u"out"_s, Text::tr("The file; one that exists is replaced."), u"FILE"_s);
    add(u"network"_s, Text::tr("Network code of miniSEED; XX if not given."), u"CODE"_s);
    add(u"station"_s, Text::tr("Station code of miniSEED; from the name of the site if not given."), u"CODE"_s);
    add(u"channels"_s, Text::tr("Channel codes of X and Y in miniSEED; BN1,BN2 if not given."), u"X,Y"_s);
    add(u"json"_s, Text::tr("Prints JSON."), {});
    add(u"lang"_s, Text::tr("Language of the program."), u"ru|en"_s);
    add(u"help"_s, Text::tr("Prints this."), {});
}

std::variant<ExportRequest, QString> exportRequest(const QCommandLineParser &parser, const ExportSite &site)
{
    return Reader(parser, site).read();
}

} // namespace gorizont::tool
