#include "core/station/correctionfile.h"
#include "core/station/stationconfig.h"

#include <QCoreApplication>
#include <QSet>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

const QString iniFile = QStringLiteral("ACK.INI");
const QString parFile = QStringLiteral("ACK.PAR");
const QString pseFile = QStringLiteral("ACK.PSE");
const QString lcdFile = QStringLiteral("ACK.LCD");
const QString fwlFile = QStringLiteral("ACK.FWL");
const QString gamFile = QStringLiteral("ACK.GAM");

QString titled(const ParameterId &id)
{
    return QStringLiteral("%1 %2").arg(id.code).arg(id.number);
}

QString lacking(const ParameterId &id)
{
    return Station::tr("ACK.PAR has no parameter %1.").arg(titled(id));
}

/// Reads the files one after another and holds them against each other.
class StationReader
{
public:
    explicit StationReader(const StationFiles &files)
        : m_files(files)
    {
    }

    StationReading read()
    {
        takeRequired();
        takeBoards();
        takeGamma();
        takeCorrections();
        checkObjects();
        checkBoards();
        return {m_config, m_complaints.list()};
    }

private:
    void complain(const QString &file, const QString &problem, const QString &action, int line = 0)
    {
        m_complaints.add({file, line, 0, {}, problem, action});
    }

    bool isThere(const QString &file, const QString &action)
    {
        if (!m_files.contains(file)) {
            complain(file, Station::tr("The file is missing."), action);
            return false;
        }
        return true;
    }

    void takeRequired()
    {
        if (isThere(pseFile, Station::tr("The usual settings are used."))) {
            m_config.settings = readSettings(pseFile, m_files.value(pseFile), m_complaints);
        }
        if (isThere(iniFile, Station::tr("The station has neither sources nor lines."))) {
            m_config.objects = readObjects(iniFile, m_files.value(iniFile), m_complaints);
        }
        if (isThere(parFile, Station::tr("The station has no parameters."))) {
            m_config.parameters = readParameters(parFile, m_files.value(parFile), m_complaints);
        }
    }

    void takeBoards()
    {
        for (const auto &[file, kind] : {std::pair(lcdFile, BoardKind::L154), std::pair(fwlFile, BoardKind::Fastwel)}) {
            if (!m_files.contains(file)) {
                continue;
            }
            auto board = readBoard(kind, file, m_files.value(file), m_complaints);
            if (board && !m_config.boards.isEmpty()) {
                countOn(*board, m_config.boards.first());
            }
            if (board) {
                m_config.boards.append(*board);
            }
        }
    }

    void takeGamma()
    {
        if (!m_files.contains(gamFile)) {
            return;
        }
        m_config.gamma = readGamma(gamFile, m_files.value(gamFile), m_complaints);
        if (m_config.gamma && m_config.indexOf(m_config.gamma->parameter) < 0) {
            complain(gamFile, lacking(m_config.gamma->parameter), Station::tr("The gamma sensor is left out."));
            m_config.gamma.reset();
        }
    }

    void takeCorrections()
    {
        static const QList<std::pair<QString, CorrectionKind>> kinds{
            {QStringLiteral("INPUT"), CorrectionKind::Input},
            {QStringLiteral("METEO"), CorrectionKind::Meteo},
            {QStringLiteral("CORRECT"), CorrectionKind::Correct},
            {QStringLiteral("REAL"), CorrectionKind::Real}};
        QSet<QString> used;
        for (const ParameterConfig &parameter : std::as_const(m_config.parameters)) {
            Corrections corrections;
            for (const auto &[prefix, kind] : kinds) {
                const QString file = QStringLiteral("%1.%2%3")
                                         .arg(prefix, parameter.code.toUpper())
                                         .arg(parameter.number, 2, 10, QLatin1Char('0'));
                if (m_files.contains(file)) {
                    readCorrection(kind, file, m_files.value(file), corrections, m_complaints);
                    checkThermometer(kind, file, corrections);
                    used.insert(file);
                }
            }
            m_config.corrections.append(corrections);
        }
        tellUnused(used);
    }

    void checkThermometer(CorrectionKind kind, const QString &file, const Corrections &corrections)
    {
        if (kind == CorrectionKind::Correct) {
            return;
        }
        const bool isNamed = kind == CorrectionKind::Input && corrections.inputThermometer;
        if (isNamed && m_config.indexOf(*corrections.inputThermometer) < 0) {
            complain(file, lacking(*corrections.inputThermometer), nothingAdded(), 1);
        } else if (!isNamed && m_config.thermometer() < 0) {
            complain(file, Station::tr("ACK.PAR has no thermometer, a parameter with the code T."), nothingAdded());
        }
    }

    static QString nothingAdded() { return Station::tr("Nothing is added."); }

    void tellUnused(const QSet<QString> &used)
    {
        for (auto file = m_files.keyBegin(); file != m_files.keyEnd(); ++file) {
            if (!file->startsWith(QStringLiteral("ACK.")) && !used.contains(*file)) {
                const QStringView suffix = QStringView(*file).right(3);
                complain(*file, lacking({suffix.front(), suffix.mid(1).toInt()}), Station::tr("The file is not used."));
            }
        }
    }

    bool hasBoard(BoardKind kind) const
    {
        return std::any_of(m_config.boards.cbegin(), m_config.boards.cend(), [kind](const BoardConfig &b) {
            return b.kind == kind;
        });
    }

    void checkObjects()
    {
        const auto checkBoard = [this](const StationObject &object, BoardKind kind, const QString &file) {
            if (!hasBoard(kind)) {
                complain(
                    iniFile, Station::tr("The source needs the file %1.").arg(file),
                    Station::tr("It measures nothing."), object.line);
            }
        };
        for (const StationObject &object : std::as_const(m_config.objects)) {
            if (object.kind == ObjectKind::L154) {
                checkBoard(object, BoardKind::L154, lcdFile);
            } else if (object.kind == ObjectKind::Fastwel) {
                checkBoard(object, BoardKind::Fastwel, fwlFile);
            } else if (object.kind == ObjectKind::Gathering && object.number != m_config.settings.number) {
                complain(
                    iniFile,
                    Station::tr("The object that gathers has the number %1 and the station, by ACK.PSE, %2.")
                        .arg(object.number)
                        .arg(m_config.settings.number),
                    Station::tr("It gathers all the same."), object.line);
            }
        }
    }

    void checkBoards()
    {
        for (const BoardConfig &board : std::as_const(m_config.boards)) {
            const QString file = board.kind == BoardKind::L154 ? lcdFile : fwlFile;
            QList<BoardInput> inputs = board.analogue + board.digital;
            if (board.frequency) {
                inputs.append({0, *board.frequency});
            }
            for (const BoardInput &input : std::as_const(inputs)) {
                const bool isEvent = input.parameter.code.toUpper() == precipitationCode;
                if (!isEvent && m_config.indexOf(input.parameter) < 0) {
                    complain(file, lacking(input.parameter), Station::tr("Its input is not used."));
                }
            }
        }
    }

    const StationFiles &m_files;
    StationConfig m_config;
    Complaints m_complaints;
};

} // namespace

StationReading readStation(const StationFiles &files)
{
    return StationReader(files).read();
}

} // namespace gorizont::station
