#include "ui/service/servicedialog.h"

#include "ui/service/portgroup.h"
#include "ui/service/servicetext.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTimer>

#include <utility>

namespace gorizont {

/// The last chance to mention a setting whose answer nobody will hear any more: the program ends.
ServiceDialog::~ServiceDialog()
{
    if (!m_writing.isEmpty()) {
        note(
            JournalKind::Error, m_writingTo,
            tr("%1, the program ended before the answer came: whether it was written is not known, check it")
                .arg(m_writing));
    }
}

void ServiceDialog::enter()
{
    endSession();
    m_end.clear();
    m_isEntering = true;
    m_session = new ServiceSession(m_port.worker, m_port.registry, m_port.line.index, this);
    connect(m_session, &ServiceSession::started, this, &ServiceDialog::start);
    connect(m_session, &ServiceSession::failed, this, [this](const QString &reason) {
        endSession();
        say(reason);
    });
    connect(m_session, &ServiceSession::ended, this, [this](const QString &reason) {
        m_end = reason;
        m_liveTimer->stop();
        m_scan->abort();
        showMessage();
        refresh();
    });
    say(tr("The port goes into service mode…"));
    refresh();
    m_session->start();
}

void ServiceDialog::start()
{
    m_isEntering = false;
    m_liveTimer->start();
    findSensors();
}

/// Polling goes on. The session lives until the event loop comes round, because this may be an answer of its own.
void ServiceDialog::endSession()
{
    m_liveTimer->stop();
    m_isEntering = false;
    m_isBusy = false;
    if (m_session) {
        breakOff();
        m_session->leave();
        m_session->disconnect(this);
        std::exchange(m_session, nullptr)->deleteLater();
        m_scan->abort();
    }
    refresh();
}

void ServiceDialog::reject()
{
    if (!m_writing.isEmpty()) {
        m_isLeaving = true;
        say(tr("The window closes as soon as the sensor has answered."));
        refresh();
        return;
    }
    confirm(isInService() ? unfinished(true) : QString(), tr("&Leave"), [this] { leave(); });
}

void ServiceDialog::leave()
{
    endSession();
    QDialog::reject();
}

void ServiceDialog::togglePort()
{
    if (!isInService()) {
        enter();
        return;
    }
    confirm(unfinished(true), tr("&Leave"), [this] {
        leavePort(tr("Service has ended, the sensors of the port are polled again."));
    });
}

void ServiceDialog::leavePort(const QString &text)
{
    endSession();
    m_address = 0;
    m_addresses->clear();
    showSensor();
    say(text);
}

void ServiceDialog::startScan(int preferred)
{
    if (!isInService()) { // lost while a question was open
        return;
    }
    m_preferred = preferred;
    m_address = 0;
    m_addresses->clear();
    showSensor();
    say({});
    m_scan->start(*m_session, probe());
    refresh();
}

void ServiceDialog::showFound()
{
    if (isInService()) {
        onScanned();
        const int index = m_addresses->findData(m_preferred);
        m_addresses->setCurrentIndex(index < 0 ? 0 : index);
        m_address = m_addresses->currentData().toInt();
        showSensor();
    }
    refresh();
}

/// The same address again is read again.
void ServiceDialog::choose(int index)
{
    const int wanted = m_addresses->itemData(index).toInt();
    confirm(
        unfinished(false), tr("&Discard"),
        [this, wanted] {
            m_address = wanted;
            say({});
            showSensor();
        },
        [this] { m_addresses->setCurrentIndex(m_addresses->findData(m_address)); });
}

void ServiceDialog::moveTo(int newAddress)
{
    m_scan->move(m_address, newAddress);
    m_address = newAddress;
    listFound();
}

void ServiceDialog::showFoundAt(int address)
{
    m_scan->add(address);
    m_address = address;
    listFound();
    showSensor();
    refresh();
}

void ServiceDialog::listFound()
{
    m_addresses->clear();
    for (const int found : m_scan->found()) {
        m_addresses->addItem(QString::number(found), found);
    }
    m_addresses->setCurrentIndex(m_addresses->findData(m_address));
}

bool ServiceDialog::isReady() const
{
    return isInService() && !m_isBusy && !m_scan->isScanning();
}

void ServiceDialog::beginWork(const QString &writing)
{
    if (!m_isBusy) {
        m_focused = focusWidget();
    }
    m_isBusy = true;
    m_writing = writing;
    m_writingTo = m_address;
    refresh();
}

/// Whoever wanted to leave meanwhile leaves now; after a failure the window stays to be read, but the port is polled again.
void ServiceDialog::endWork(bool isGood)
{
    m_isBusy = false;
    m_writing.clear();
    refresh();
    if (m_focused && m_focused->isEnabled()) {
        m_focused->setFocus();
    }
    if (std::exchange(m_isLeaving, false)) {
        if (isGood) {
            reject();
        } else {
            endSession();
        }
    }
}

void ServiceDialog::refresh()
{
    m_portGroup->setInService(isInService());
    m_portGroup->setButtonEnabled(!m_isEntering && m_writing.isEmpty());
    m_addresses->setEnabled(isInService() && !m_scan->isScanning() && m_writing.isEmpty() && m_addresses->count() > 0);
    m_scan->setScanEnabled(isInService() && !m_isBusy);
    m_exit->setEnabled(!m_isLeaving);
    updateControls();
}

void ServiceDialog::say(const QString &text, const QString &more)
{
    m_said = text.isEmpty() || more.isEmpty() ? text + more : text + u'\n' + more;
    showMessage();
}

void ServiceDialog::showMessage()
{
    QStringList texts{m_end, m_said};
    texts.removeAll(QString());
    m_message->setText(texts.join(u'\n'));
}

void ServiceDialog::note(JournalKind kind, int address, const QString &text)
{
    const QString device = servicetext::deviceName(m_type);
    const QString whole = servicetext::hasAddresses(m_type)
        ? tr("%1, %2 address %3: %4").arg(m_port.line.title(), device, QString::number(address), text)
        : tr("%1, %2: %3").arg(m_port.line.title(), device, text);
    m_port.journal.append(
        {kind, utcNow(), whole, m_port.line.index, servicetext::numberAt(m_port.line, m_type, address)});
}

} // namespace gorizont
