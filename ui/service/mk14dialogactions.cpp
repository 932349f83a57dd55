// What the service window of a МК-14 changes in the station: outputs, clock, settings files.

#include "ui/models/weathertext.h"
#include "ui/service/mk14dialog.h"
#include "ui/service/mk14form.h"
#include "ui/service/mk14outputspanel.h"
#include "ui/service/mk14transferpanel.h"
#include "ui/service/mk14valuespanel.h"
#include "ui/service/servicetext.h"

#include <QFileDialog>

#include <algorithm>

namespace gorizont {

namespace {

/// Which key keeps \a word beyond the end of the program.
QString outputsReminder(const LineConfig &line, int address, quint32 word)
{
    const auto station = std::ranges::find_if(line.sensors, [address](const SensorConfig &sensor) {
        return sensor.type == SensorType::Mk14 && sensor.address == address;
    });
    return Mk14Dialog::tr("To keep it, write Outputs%1=%2 into [Port%3] of the configuration file.")
        .arg(station->index)
        .arg(word)
        .arg(line.index);
}

} // namespace

void Mk14Dialog::begin(const QString &what)
{
    beginWork(what);
    say(tr("Writing: %1…").arg(what));
}

void Mk14Dialog::end(int to, bool isGood, const QString &text)
{
    note(isGood ? JournalKind::Info : JournalKind::Error, to, text);
    say(tr("Station %1: %2").arg(to).arg(text));
    endWork(isGood);
}

void Mk14Dialog::askOutputs()
{
    const quint32 word = m_form->outputs()->word();
    confirm(
        tr("Set the outputs of station %1 to %2? Whatever is connected to them is switched at once.")
            .arg(QString::number(address()), weathertext::digital(word)),
        tr("&Set"), [this, word] { setOutputs(word); });
}

void Mk14Dialog::setOutputs(quint32 word)
{
    if (!isReady() || !m_isShown) { // lost while the question was open
        return;
    }
    const int to = address();
    const QString what = tr("outputs %1").arg(weathertext::digital(word));
    begin(what);
    run([service = service(), to, word](Line &line) { return service.setOutputs(line, to, word); },
        [this, to, word, what](const Result<Weather> &set) {
            if (set) {
                m_form->outputs()->showWord(word);
                m_form->values()->showWeather(
                    *set, clock(), precipitation::stationTime(QDateTime::currentDateTime(), clock()));
            }
            end(to, bool(set),
                set ? tr("%1, confirmed. %2").arg(what, outputsReminder(port().line, to, word))
                    : tr("%1, not confirmed (%2): whether the outputs were switched is not known; polling goes on with "
                         "the word before.")
                          .arg(what, servicetext::fault(set.fault())));
        });
}

void Mk14Dialog::askTime()
{
    confirm(
        clock() == precipitation::StationClock::Utc
            ? tr("Set the clock of station %1 to the time of this computer, UTC? Times of its records will step.")
                  .arg(address())
            : tr("Set the clock of station %1 to the local time of this computer? Times of its records will step.")
                  .arg(address()),
        tr("&Set"), [this] { setTime(); });
}

void Mk14Dialog::setTime()
{
    if (!isReady() || !m_isShown) { // lost while the question was open
        return;
    }
    const int to = address();
    const QString what = tr("clock");
    begin(what);
    run([service = service(), to](Line &line) { return service.setTime(line, to); },
        [this, to, what, clock = clock()](const Result<qint64> &sent) {
            if (!sent) {
                end(to, false,
                    tr("%1, not confirmed (%2): whether it was set is not known.")
                        .arg(what, servicetext::fault(sent.fault())));
                return;
            }
            // What the station's clock shows is what its seconds are in UTC, whichever rule it follows.
            const QString time =
                QDateTime::fromSecsSinceEpoch(*sent, Qt::UTC).toString(QStringLiteral("dd.MM.yyyy HH:mm:ss"));
            const bool isUtc = clock == precipitation::StationClock::Utc;
            end(to, true, tr("%1 set to %2, confirmed").arg(what, isUtc ? time + QStringLiteral(" UTC") : time));
        });
}

/// Returns at once; the file is read when a name has been chosen.
void Mk14Dialog::chooseFile()
{
    auto *dialog = new QFileDialog(this, tr("Settings file for the station"));
    dialog->setObjectName(QStringLiteral("stationFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        say(m_form->transfer()->takeFile(path));
        updateControls();
    });
    dialog->open();
}

void Mk14Dialog::askFile()
{
    const QByteArray name = m_form->transfer()->fileName();
    const QByteArray file = m_form->transfer()->file();
    confirm(
        tr("Send %1 (%n byte(s)) to station %2? It replaces the station's own file of this name. A wrong file may stop "
           "its measurements.",
           nullptr, static_cast<int>(file.size()))
            .arg(QString::fromLatin1(name), QString::number(address())),
        tr("&Send"), [this, name, file] { sendFile(name, file); });
}

void Mk14Dialog::sendFile(const QByteArray &name, const QByteArray &file)
{
    if (!isReady() || !m_isShown) { // lost while the question was open
        return;
    }
    const int to = address();
    const QString what =
        tr("file %1, %n byte(s)", nullptr, static_cast<int>(file.size())).arg(QString::fromLatin1(name));
    begin(what);
    run([service = service(), to, name, file](Line &line) { return service.sendFile(line, to, name, file); },
        [this, to, what](const Result<void> &sent) {
            end(to, bool(sent),
                sent ? tr("%1, confirmed").arg(what)
                     : tr("%1, not confirmed (%2): the station may have it or not. Send it again.")
                           .arg(what, servicetext::fault(sent.fault())));
        });
}

} // namespace gorizont
