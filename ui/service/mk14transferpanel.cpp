#include "ui/service/mk14transferpanel.h"

#include "ui/models/valuetext.h"
#include "ui/service/valuelabel.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace gorizont {

namespace {

QPushButton *makeButton(const QString &text, const QString &objectName, QWidget *parent)
{
    auto *button = new QPushButton(text, parent);
    button->setObjectName(objectName);
    button->setAutoDefault(false);
    return button;
}

QLabel *sentence(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setWordWrap(true);
    return label;
}

} // namespace

Mk14TransferPanel::Mk14TransferPanel(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("mk14Transfer"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(makeClock());
    layout->addWidget(makeFile());
    layout->addStretch(1);
    connect(m_setTime, &QPushButton::clicked, this, &Mk14TransferPanel::timeWanted);
    connect(m_choose, &QPushButton::clicked, this, &Mk14TransferPanel::fileWanted);
    connect(m_name, &QLineEdit::textChanged, this, &Mk14TransferPanel::edited);
    connect(m_send, &QPushButton::clicked, this, &Mk14TransferPanel::sendWanted);
    showFile();
}

QGroupBox *Mk14TransferPanel::makeClock()
{
    auto *group = new QGroupBox(tr("Clock of the station"), this);
    m_rule = sentence({}, group);
    m_rule->setObjectName(QStringLiteral("clockRule"));
    m_time = valueLabel(QStringLiteral("clockTime"), QStringLiteral("28.11.2026 23:59:59 UTC"), group);
    m_setTime = makeButton(tr("Set the c&lock…"), QStringLiteral("setTime"), group);
    auto *grid = new QGridLayout(group);
    grid->addWidget(m_rule, 0, 0, 1, 3);
    grid->addWidget(new QLabel(tr("Time that is sent:"), group), 1, 0);
    grid->addWidget(m_time, 1, 1);
    grid->addWidget(m_setTime, 1, 2);
    grid->setColumnStretch(1, 1);
    return group;
}

QGroupBox *Mk14TransferPanel::makeFile()
{
    auto *group = new QGroupBox(tr("Settings file"), this);
    auto *hint = sentence(
        tr("The station replaces its own file of this name and may work by it at once or after a restart. Keep a copy "
           "of the old one: it cannot be read back."),
        group);
    m_choose = makeButton(tr("C&hoose the file…"), QStringLiteral("chooseFile"), group);
    m_chosen = sentence({}, group);
    m_chosen->setObjectName(QStringLiteral("chosenFile"));
    m_chosen->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_name = new QLineEdit(group);
    m_name->setObjectName(QStringLiteral("stationFileName"));
    m_name->setMaxLength(longestName);
    m_name->setToolTip(tr("The name under which the station gets the file, in Latin letters"));
    m_send = makeButton(tr("&Send the file…"), QStringLiteral("sendFile"), group);
    auto *name = new QLabel(tr("&Name in the station:"), group);
    name->setBuddy(m_name);
    auto *grid = new QGridLayout(group);
    grid->addWidget(hint, 0, 0, 1, 3);
    grid->addWidget(m_choose, 1, 0);
    grid->addWidget(m_chosen, 1, 1, 1, 2);
    grid->addWidget(name, 2, 0);
    grid->addWidget(m_name, 2, 1);
    grid->addWidget(m_send, 2, 2);
    grid->setColumnStretch(1, 1);
    return group;
}

QWidgetList Mk14TransferPanel::tabOrder() const
{
    return {m_setTime, m_choose, m_name, m_send};
}

void Mk14TransferPanel::showClock(const QDateTime &now, precipitation::StationClock clock)
{
    const bool isUtc = clock == precipitation::StationClock::Utc;
    m_rule->setText(
        isUtc ? tr("The configuration file says that the clock of this station shows UTC (StationClock=UTC).")
              : tr("The clock of this station shows local time; StationClock{i}=UTC in the configuration file would "
                   "say otherwise."));
    const QString format = QStringLiteral("dd.MM.yyyy HH:mm:ss");
    m_time->setText(isUtc ? now.toUTC().toString(format) + QStringLiteral(" UTC") : now.toString(format));
}

QString Mk14TransferPanel::takeFile(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return tr("The file cannot be read: %1. Choose another one.").arg(file.errorString());
    }
    const QByteArray bytes = file.read(longestFile + 1); // a device or a growing file has no size
    if (file.error() != QFileDevice::NoError) {
        return tr("The file cannot be read: %1. Choose another one.").arg(file.errorString());
    }
    if (bytes.isEmpty()) {
        return tr("The file is empty: the station would lose its settings. Choose another one.");
    }
    if (bytes.size() > longestFile) {
        return tr("The file has more than %1 bytes: the station takes only small ones. Choose another one.")
            .arg(longestFile);
    }
    m_path = path;
    m_file = bytes;
    m_name->setText(latin(QFileInfo(path).fileName()));
    showFile();
    return {};
}

void Mk14TransferPanel::showFile()
{
    m_chosen->setText(
        m_path.isEmpty()
            ? tr("No file is chosen.")
            : tr("%1, %n byte(s)", nullptr, static_cast<int>(m_file.size())).arg(QDir::toNativeSeparators(m_path)));
}

QString Mk14TransferPanel::latin(const QString &name)
{
    static const QString cyrillic = QStringLiteral("АВЕКМНОРСТХавекмнорстх");
    static const QString alike = QStringLiteral("ABEKMHOPCTXabekmhopctx");
    QString result = name;
    for (QChar &letter : result) {
        const qsizetype at = cyrillic.indexOf(letter);
        letter = at < 0 ? letter : alike.at(at);
    }
    return result;
}

/// A path would reach beyond the folder of the station.
QByteArray Mk14TransferPanel::fileName() const
{
    const QString name = m_name->text().trimmed();
    const bool isLatin = std::ranges::all_of(name, [](QChar letter) {
        return letter.unicode() > 0x20 && letter.unicode() < 0x7F && letter != u'/' && letter != u'\\'
            && letter != u':';
    });
    return isLatin ? name.toLatin1() : QByteArray();
}

void Mk14TransferPanel::setControls(bool isShown)
{
    m_setTime->setEnabled(isShown);
    m_choose->setEnabled(isShown);
    m_name->setEnabled(isShown && !m_file.isEmpty());
    m_send->setEnabled(isShown && !m_file.isEmpty() && !fileName().isEmpty());
    m_send->setToolTip(
        m_file.isEmpty() || !fileName().isEmpty()
            ? QString()
            : tr("The name may have Latin letters, digits and signs, but no blanks and no folders."));
}

} // namespace gorizont
