// What the service window of L-VIMS tells a module, each thing behind its own warning; and its files.

#include "core/files/wholefile.h"
#include "ui/service/servicetext.h"
#include "ui/service/vimsdialog.h"
#include "ui/service/vimsform.h"
#include "ui/service/vimsmodulepanel.h"
#include "ui/service/vimssettingspanel.h"
#include "ui/service/vimstext.h"

#include <QFile>
#include <QFileDialog>

namespace gorizont {

using namespace lvims;

namespace {

QString lines(QStringList texts)
{
    texts.removeAll(QString());
    return texts.join(QStringLiteral("\n\n"));
}

} // namespace

void VimsDialog::askWrite()
{
    const auto changes = differences(m_prepared, m_form->settings()->wanted());
    confirm(
        lines(
            {tr("Prepare these settings in the module (MUT)? It does not use them before <Apply>, nor after a "
                "restart."),
             vimstext::differences(changes)}),
        tr("&Write"), [this] { write(); });
}

void VimsDialog::write()
{
    if (!isReady()) { // lost while the question was open
        return;
    }
    beginWork(tr("settings prepared"));
    say(tr("Writing the settings…"));
    const auto pieces = piecesToWrite(m_prepared, m_form->settings()->wanted());
    writeNext(pieces, pieces.size());
}

void VimsDialog::writeNext(const QList<SettingPiece> &left, qsizetype total)
{
    m_form->showProgress(total - left.size(), total);
    const auto check = [this](const Result<void> &written) {
        run([service = m_service](Line &line) { return service->readErrors(line); },
            [this, written](const Result<SettingErrors> &errors) { endWriting(errors, written); });
    };
    if (left.isEmpty()) {
        check({});
        return;
    }
    run([service = m_service, piece = left.constFirst()](Line &line) { return service->write(line, piece); },
        [this, left, total, check](const Result<void> &written) {
            if (written) {
                writeNext(left.mid(1), total);
            } else {
                check(written);
            }
        });
}

void VimsDialog::endWriting(const Result<SettingErrors> &errors, const Result<void> &written)
{
    const bool isGood = written && errors && errors->first == 0;
    QString text = tr("settings prepared in the module; it does not use them yet");
    if (errors) {
        m_form->module()->showErrors(*errors);
    }
    if (!isGood) {
        const Fault fault = !written ? written.fault() : errors ? Fault::Refused : errors.fault();
        text = tr("the settings were not written whole: %1%2")
                   .arg(
                       servicetext::fault(fault),
                       errors ? QStringLiteral(" (%1)").arg(vimstext::errors(*errors)) : QString());
    }
    note(isGood ? JournalKind::Info : JournalKind::Error, address(), text);
    const bool leaves = isLeaving();
    const bool goesOn = isGood && !leaves && isInService();
    m_form->showProgress(0, 0);
    say(text);
    if (isGood) {
        m_prepared = m_form->settings()->wanted();
        m_form->settings()->showModule(m_inUse, m_prepared);
    }
    endWork(isGood);
    if (goesOn) {
        read(text);
    }
}

void VimsDialog::ask(const QString &question, const QString &yes, const Order &order)
{
    confirm(question, yes, [this, order] { give(order); });
}

void VimsDialog::askApply()
{
    const auto changes = differences(m_inUse, m_prepared);
    const bool cutsOff = vimstext::touchesNetwork(changes);
    ask(lines(
            {tr("Let the module use the prepared settings from now on? Measurements and relays follow them at once."),
             changes.isEmpty() ? tr("They do not differ from those in use.") : vimstext::differences(changes),
             m_form->settings()->isEdited() ? tr("What was changed here and not written is not among them.")
                                            : QString(),
             cutsOff ? vimstext::networkWarning(m_prepared, port().line.index) : QString()}),
        tr("&Apply"),
        {tr("settings applied"), [](Service &service, Line &line) { return service.apply(line); }, cutsOff});
}

void VimsDialog::askFlash()
{
    const bool isOther = vimstext::touchesNetwork(differences(m_inUse, m_prepared));
    ask(lines(
            {tr("Keep the prepared settings in the flash of the module? It starts with them from now on; those that "
                "were "
                "there before are lost."),
             isOther ? tr("After its next start the module has another network address: %1.")
                           .arg(valueOf(m_prepared, *settingNamed(QStringLiteral("IP_ADDR"))))
                     : QString()}),
        tr("&Keep"),
        {tr("settings kept in flash"), [](Service &service, Line &line) { return service.saveToFlash(line); }});
}

void VimsDialog::askReload()
{
    ask(tr("Let the module use the settings of its flash again? What was prepared or applied and not kept is lost. If "
           "its "
           "network address is another one there, the connection will be lost."),
        tr("&Reload"),
        {tr("settings reloaded from flash"), [](Service &service, Line &line) { return service.loadFromFlash(line); }});
}

void VimsDialog::askRestart()
{
    confirm(
        lines(
            {unfinished(true),
             tr("Restart the module? It measures nothing meanwhile, its relays may change, and settings that were not "
                "kept "
                "in flash are lost.")}),
        tr("&Restart"), [this] { restart(); });
}

void VimsDialog::give(const Order &order)
{
    if (!isReady()) { // lost while the question was open
        return;
    }
    beginWork(order.what);
    say(tr("Writing: %1…").arg(order.what));
    run([service = m_service, give = order.give](Line &line) { return give(*service, line); },
        [this, order](const Result<void> &given) { checkOrder(order, given); });
}

/// A module that has another address now answers nobody here.
void VimsDialog::checkOrder(const Order &order, const Result<void> &given)
{
    const bool isGone = !given && (given.fault() == Fault::Timeout || given.fault() == Fault::Closed);
    if (order.cutsOff && (given || isGone)) {
        const QString text = tr("%1; the module has its new network address").arg(order.what);
        note(JournalKind::Info, address(), text);
        say(text, vimstext::networkWarning(m_prepared, port().line.index));
        endWork();
        return;
    }
    run([service = m_service](Line &line) { return service->readErrors(line); },
        [this, order, given](const Result<SettingErrors> &errors) {
            const bool isGood = given && errors && *errors == SettingErrors(0, 0);
            QString text = order.what;
            if (!isGood) {
                const Fault fault = !given ? given.fault() : errors ? Fault::Refused : errors.fault();
                text = tr("%1, not done: %2%3")
                           .arg(
                               order.what, servicetext::fault(fault),
                               errors ? QStringLiteral(" (%1)").arg(vimstext::errors(*errors)) : QString());
            }
            note(isGood ? JournalKind::Info : JournalKind::Error, address(), text);
            const bool reads = !isLeaving() && isInService();
            say(text);
            const bool isEdited = m_form->settings()->isEdited();
            endWork(isGood);
            if (errors) {
                m_form->module()->showErrors(*errors);
            }
            if (reads && !isEdited) { // what was typed stays
                read(text);
            }
        });
}

/// Polling goes on and finds the module when it is back.
void VimsDialog::restart()
{
    if (!isReady()) {
        return;
    }
    const QString what = tr("restart");
    beginWork(what);
    say(tr("Writing: %1…").arg(what));
    run([service = m_service](Line &line) { return service->restart(line); },
        [this, what](const Result<void> &done) {
            const QString text =
                done ? tr("the module restarts") : tr("%1, not done: %2").arg(what, servicetext::fault(done.fault()));
            note(done ? JournalKind::Info : JournalKind::Error, address(), text);
            const bool leaves = isLeaving();
            endWork(bool(done));
            if (done && !leaves) {
                leavePort(tr("The module restarts. Service has ended; it is polled again as soon as it answers."));
            } else {
                say(text);
            }
        });
}

/// Returns at once; the form is filled when a file has been chosen.
void VimsDialog::openFile()
{
    auto *dialog = new QFileDialog(this, tr("Open settings"));
    dialog->setObjectName(QStringLiteral("settingsFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilter(QStringLiteral("*.json"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &VimsDialog::takeFile);
    dialog->open();
}

void VimsDialog::takeFile(const QString &path)
{
    QFile file(path);
    const auto image = file.open(QIODevice::ReadOnly) ? settingsIn(file.readAll()) : std::nullopt;
    if (!image) {
        say(tr("%1 is no file of settings. Choose one that this window or gorizont-tool vims has saved.").arg(path));
        return;
    }
    m_form->settings()->want(*image);
    say(tr("The form shows the settings of %1. <Write> prepares them in the module.").arg(path));
}

void VimsDialog::saveFile()
{
    auto *dialog = new QFileDialog(this, tr("Save the settings"));
    dialog->setObjectName(QStringLiteral("settingsFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(QStringLiteral("*.json"));
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->selectFile(QStringLiteral("L-VIMS %1.json").arg(m_identity->serial));
    connect(
        dialog, &QFileDialog::fileSelected, this,
        [this, bytes = settingsFile(*m_identity, m_inUse)](const QString &path) {
            const QString error = writeWholeFile(path, bytes);
            say(error.isEmpty() ? tr("The settings in use are in %1.").arg(path)
                                : tr("The settings were not saved (%1). Choose another folder.").arg(error));
        });
    dialog->open();
}

} // namespace gorizont
