#include "ui/service/scanpanel.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace gorizont {

namespace {

QString listed(const QList<int> &addresses)
{
    QStringList texts;
    for (const int address : addresses) {
        texts += QString::number(address);
    }
    return texts.join(QStringLiteral(", "));
}

} // namespace

ScanPanel::ScanPanel(QWidget *parent)
    : QWidget(parent)
    , m_count(new QLabel(this))
    , m_button(new QPushButton(this))
    , m_progress(new QProgressBar(this))
    , m_text(new QLabel(this))
{
    m_count->setObjectName(QStringLiteral("foundCount"));
    m_count->setMinimumWidth(fontMetrics().horizontalAdvance(QString::number(AddressScan::last)));
    m_button->setObjectName(QStringLiteral("scanButton"));
    m_progress->setObjectName(QStringLiteral("scanProgress"));
    m_progress->setTextVisible(false);
    m_progress->setRange(0, AddressScan::last);
    m_text->setObjectName(QStringLiteral("scanText"));
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_text->setMinimumHeight(2 * fontMetrics().lineSpacing());
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new QLabel(tr("Sensors found on the line:"), this), 0, 0);
    layout->addWidget(m_count, 0, 1);
    layout->addWidget(m_progress, 0, 2);
    layout->addWidget(m_button, 0, 3);
    layout->addWidget(m_text, 1, 0, 1, 4);
    layout->setColumnStretch(2, 1);
    setFocusProxy(m_button);
    connect(m_button, &QPushButton::clicked, this, [this] {
        if (m_isScanning) {
            stop();
        } else {
            Q_EMIT scanWanted();
        }
    });
    refresh();
}

void ScanPanel::start(ServiceSession &session, const Probe &probe)
{
    m_session = &session;
    m_probe = probe;
    m_scan = AddressScan();
    m_found.clear();
    m_unclear.clear();
    ++m_run;
    m_isScanning = true;
    m_isStopping = false;
    m_isComplete = false;
    probeNext();
}

void ScanPanel::stop()
{
    m_isStopping = m_isScanning;
    refresh();
}

void ScanPanel::abort()
{
    if (m_isScanning) {
        finish();
    }
}

void ScanPanel::setScanEnabled(bool isEnabled)
{
    m_isScanEnabled = isEnabled;
    refresh();
}

void ScanPanel::probeNext()
{
    refresh();
    m_session->run(
        [probe = m_probe, address = m_scan.next()](Line &line) { return probe(line, address); },
        [this, run = m_run](const Result<void> &probed) {
            if (m_isScanning && run == m_run) {
                take(probed);
            }
        });
}

void ScanPanel::take(const Result<void> &probed)
{
    if (!probed && isLineFault(probed.fault())) {
        finish();
        return;
    }
    const int address = m_scan.next();
    m_scan.record(probed);
    m_found = m_scan.found();
    m_unclear = m_scan.unclear();
    if (probed) {
        Q_EMIT sensorFound(address);
    }
    if (m_scan.next() == 0 || m_isStopping) {
        finish();
    } else {
        probeNext();
    }
}

void ScanPanel::finish()
{
    m_isScanning = false;
    m_isStopping = false;
    m_isComplete = m_scan.isComplete();
    ++m_run;
    refresh();
    Q_EMIT finished();
}

QList<int> ScanPanel::free() const
{
    QList<int> addresses;
    for (int address = AddressScan::first; m_isComplete && address <= AddressScan::last; ++address) {
        if (!m_found.contains(address) && !m_unclear.contains(address)) {
            addresses.append(address);
        }
    }
    return addresses;
}

void ScanPanel::add(int address)
{
    if (!m_found.contains(address)) {
        m_found.insert(std::lower_bound(m_found.begin(), m_found.end(), address), address);
    }
    refresh();
}

void ScanPanel::move(int from, int to)
{
    m_found.removeOne(from);
    add(to);
}

void ScanPanel::distrust()
{
    m_isComplete = false;
    refresh();
}

void ScanPanel::refresh()
{
    m_count->setText(QString::number(m_found.size()));
    m_progress->setValue(m_scan.probed());
    m_button->setText(m_isScanning ? tr("&Stop") : tr("&Scan"));
    m_button->setEnabled(m_isScanning ? !m_isStopping : m_isScanEnabled);
    m_text->setText(m_isScanning ? progressText() : resultText());
}

QString ScanPanel::progressText() const
{
    const QString asked = tr("Address %1 of %2 is asked.").arg(m_scan.next()).arg(AddressScan::last);
    return m_found.isEmpty() ? asked : asked + u' ' + tr("Found: %1.").arg(listed(m_found));
}

QString ScanPanel::resultText() const
{
    QStringList texts;
    if (!m_unclear.isEmpty()) {
        texts +=
            tr("Unclear: %1. Somebody answers there, but the answers are damaged: two sensors with one address look "
               "like that. Disconnect one of them and scan again.")
                .arg(listed(m_unclear));
    }
    if (m_isComplete) {
        texts += m_found.isEmpty() ? tr("Nobody answers. Check power, cable and speed.") : QString();
    } else if (m_run > 0) {
        texts += tr("The scan is not complete: a sensor cannot get a new address before all %1 addresses were asked.")
                     .arg(AddressScan::last);
    }
    texts.removeAll(QString());
    return texts.join(u'\n');
}

} // namespace gorizont
