#include "ui/firstrundialog.h"

#include "ui/models/icons.h"

#include <QCommandLinkButton>
#include <QFileDialog>
#include <QLabel>
#include <QVBoxLayout>

namespace gorizont {

FirstRunDialog::FirstRunDialog(const QStringList &expected, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("firstRunDialog"));
    setWindowTitle(tr("Gorizont Server: first start"));
    setWindowIcon(icons::program());
    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->setContentsMargins(18, 18, 18, 18);
    auto *heading = new QLabel(tr("There is no configuration file GorizontServer.ini yet."), this);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    auto *places = new QLabel(tr("It was looked for here:") + u'\n' + expected.join(u'\n'), this);
    places->setTextInteractionFlags(Qt::TextSelectableByMouse);
    places->setWordWrap(true);
    layout->addWidget(heading);
    layout->addWidget(places);
    addChoice(
        Choice::StartDemo, tr("Start the demo"), tr("A simulated site with sensors; no equipment is needed"),
        QStringLiteral("startDemo"));
    addChoice(
        Choice::ChooseFile, tr("Choose a file"), tr("Open a configuration file that already exists"),
        QStringLiteral("chooseFile"));
    addChoice(Choice::Quit, tr("Quit"), tr("Nothing is changed"), QStringLiteral("quit"));
    setMinimumWidth(520);
}

void FirstRunDialog::addChoice(Choice choice, const QString &title, const QString &meaning, const QString &objectName)
{
    auto *button = new QCommandLinkButton(title, meaning, this);
    button->setObjectName(objectName);
    connect(button, &QCommandLinkButton::clicked, this, [this, choice] {
        m_choice = choice;
        done(choice == Choice::Quit ? Rejected : Accepted);
    });
    layout()->addWidget(button);
}

QString FirstRunDialog::askForFile(QWidget *parent)
{
    return QFileDialog::getOpenFileName(
        parent, tr("Configuration file"), {}, tr("Configuration files (*.ini);;All files (*)"));
}

} // namespace gorizont
