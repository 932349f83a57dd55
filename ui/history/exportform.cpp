#include "ui/history/exportform.h"

#include "core/export/exportnames.h"
#include "ui/history/checklist.h"
#include "ui/models/statetext.h"

#include <QComboBox>
#include <QDateTimeEdit>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QStandardPaths>

namespace gorizont {

namespace {

UtcTime utcOf(const QDateTime &local)
{
    return UtcTime(std::chrono::milliseconds(local.toMSecsSinceEpoch()));
}

QString suffixOf(ExportFormat format)
{
    return format == ExportFormat::MiniSeed ? QStringLiteral("mseed") : QStringLiteral("csv");
}

/// In the folder of documents; the days are in the name.
QString suggestedPath(const ExportForm::Start &start)
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString days = start.first == start.last
        ? start.first.toString(Qt::ISODate)
        : start.first.toString(Qt::ISODate) + u'_' + start.last.toString(Qt::ISODate);
    return QDir(folder).filePath(QStringLiteral("gorizont_%1.csv").arg(days));
}

} // namespace

ExportForm::ExportForm(const Start &start, QWidget *parent)
    : QWidget(parent)
    , m_all(start.sensors)
    , m_from(new QDateTimeEdit(this))
    , m_to(new QDateTimeEdit(this))
    , m_format(new QComboBox(this))
    , m_every(new QComboBox(this))
    , m_sensors(new CheckList(QStringLiteral("exportSensors"), tr("All sensors"), this))
    , m_quantities(new CheckList(QStringLiteral("exportQuantities"), tr("All quantities"), this))
    , m_codes(new QGroupBox(tr("Codes in miniSEED"), this))
    , m_network(codeField("exportNetwork", SeedCodes().network, 2))
    , m_station(codeField("exportStation", start.station, 5))
    , m_channelX(codeField("exportChannelX", SeedCodes().channelX, 3))
    , m_channelY(codeField("exportChannelY", SeedCodes().channelY, 3))
    , m_path(new QLineEdit(QDir::toNativeSeparators(suggestedPath(start)), this))
{
    m_path->setObjectName(QStringLiteral("exportPath"));
    addRange(start);
    addChoices(start);
    build();
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportForm::follow);
    follow();
}

QLineEdit *ExportForm::codeField(const char *name, const QString &code, int length)
{
    auto *field = new QLineEdit(code, this);
    field->setObjectName(QLatin1String(name));
    field->setValidator(
        new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[A-Z0-9]{0,%1}").arg(length)), field));
    return field;
}

void ExportForm::addRange(const Start &start)
{
    for (QDateTimeEdit *edit : {m_from, m_to}) {
        edit->setDisplayFormat(QStringLiteral("dd.MM.yyyy HH:mm:ss"));
        edit->setCalendarPopup(true);
    }
    m_from->setObjectName(QStringLiteral("exportFrom"));
    m_to->setObjectName(QStringLiteral("exportTo"));
    m_from->setDateTime(start.first.startOfDay());
    m_to->setDateTime(start.last.addDays(1).startOfDay());
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_format->addItem(tr("CSV for Excel (semicolons, local time)"), int(ExportFormat::CsvRussian));
    m_format->addItem(tr("CSV for programs (ISO 8601, UTC)"), int(ExportFormat::CsvIso));
    m_format->addItem(tr("miniSEED (samples of accelerometers)"), int(ExportFormat::MiniSeed));
    m_every->setObjectName(QStringLiteral("exportEvery"));
    m_every->addItem(tr("each reading"), int(ExportEvery::Reading));
    m_every->addItem(tr("each minute: minimum, mean, maximum"), int(ExportEvery::Minute));
    m_every->addItem(tr("each hour: minimum, mean, maximum"), int(ExportEvery::Hour));
    m_every->addItem(tr("each day: minimum, mean, maximum"), int(ExportEvery::Day));
}

void ExportForm::addChoices(const Start &start)
{
    QList<int> measured;
    for (const SensorConfig &sensor : start.sensors) {
        m_sensors->add(statetext::sensorTitle(sensor), sensor.number);
        for (const Quantity quantity : quantitiesOf(sensor)) {
            if (!measured.contains(int(quantity))) {
                measured << int(quantity);
            }
        }
    }
    m_sensors->setChosen(start.chosen);
    std::sort(measured.begin(), measured.end());
    QList<int> readings;
    for (const int quantity : measured) {
        const auto which = static_cast<Quantity>(quantity);
        m_quantities->add(QStringLiteral("%1, %2").arg(exportname::quantity(which), exportname::unit(which)), quantity);
        if (readingQuantities().contains(which)) {
            readings << quantity;
        }
    }
    m_quantities->setChosen(readings); // samples make a table ten times as long
}

void ExportForm::build()
{
    auto *codes = new QFormLayout(m_codes);
    codes->addRow(tr("Network:"), m_network);
    codes->addRow(tr("Station:"), m_station);
    codes->addRow(tr("Channel X:"), m_channelX);
    codes->addRow(tr("Channel Y:"), m_channelY);
    m_codes->setObjectName(QStringLiteral("exportCodes"));
    auto *choices = new QHBoxLayout;
    choices->addWidget(m_sensors, 1);
    choices->addWidget(m_quantities, 1);
    choices->addWidget(m_codes, 1);
    auto *browseButton = new QPushButton(tr("&Browse…"), this);
    browseButton->setObjectName(QStringLiteral("exportBrowse"));
    browseButton->setAutoDefault(false);
    connect(browseButton, &QPushButton::clicked, this, &ExportForm::browse);
    auto *file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(browseButton);
    auto *layout = new QFormLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addRow(tr("&From:"), m_from);
    layout->addRow(tr("&To (not included):"), m_to);
    layout->addRow(tr("F&ormat:"), m_format);
    layout->addRow(tr("&Rows:"), m_every);
    layout->addRow(choices);
    auto *fileLabel = new QLabel(tr("Fi&le:"), this);
    fileLabel->setBuddy(m_path);
    layout->addRow(fileLabel, file);
}

ExportFormat ExportForm::format() const
{
    return static_cast<ExportFormat>(m_format->currentData().toInt());
}

/// miniSEED has codes instead of quantities, and all samples.
void ExportForm::follow()
{
    const bool isSeed = format() == ExportFormat::MiniSeed;
    m_every->setEnabled(!isSeed);
    m_quantities->setVisible(!isSeed);
    m_codes->setVisible(isSeed);
    const QFileInfo file(path());
    if (!file.fileName().isEmpty()) {
        setPath(QDir(file.path()).filePath(file.completeBaseName() + u'.' + suffixOf(format())));
    }
}

QString ExportForm::path() const
{
    return QDir::fromNativeSeparators(m_path->text().trimmed());
}

void ExportForm::setPath(const QString &path)
{
    m_path->setText(QDir::toNativeSeparators(path));
}

void ExportForm::browse()
{
    auto *dialog = new QFileDialog(this, tr("File of the export"), QFileInfo(path()).path());
    dialog->setObjectName(QStringLiteral("exportFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffixOf(format()));
    dialog->selectFile(QFileInfo(path()).fileName());
    connect(dialog, &QFileDialog::fileSelected, this, &ExportForm::setPath);
    dialog->open();
}

ExportRequest ExportForm::request() const
{
    ExportRequest request;
    request.format = format();
    const QList<int> chosen = m_sensors->chosen();
    for (const SensorConfig &sensor : m_all) {
        if (chosen.contains(sensor.number)) {
            request.sensors << sensor;
        }
    }
    for (const int quantity : m_quantities->chosen()) {
        request.quantities << static_cast<Quantity>(quantity);
    }
    request.from = utcOf(m_from->dateTime());
    request.to = utcOf(m_to->dateTime());
    request.every = static_cast<ExportEvery>(m_every->currentData().toInt());
    request.seed = {m_network->text(), m_station->text(), m_channelX->text(), m_channelY->text()};
    request.path = path();
    return request;
}

} // namespace gorizont
