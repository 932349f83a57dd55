// The search by serial number and measuring in the service window of УСМ-ИСН.

#include "ui/service/usmdevicepanel.h"
#include "ui/service/usmdialog.h"
#include "ui/service/usmform.h"
#include "ui/service/usmtext.h"

#include <QDateTime>

namespace gorizont {

using namespace usmisn;

void UsmDialog::find()
{
    const QList<quint32> serials = m_form->serials();
    if (!serials.isEmpty() && begin(Task::Find)) {
        findNext(serials, {}, 0);
    }
}

/// \a first: the first address found; 0: none so far.
void UsmDialog::findNext(const QList<quint32> &left, const QStringList &report, int first)
{
    say(report.join(u'\n'), left.isEmpty() ? QString() : tr("Looking for %1…").arg(usmtext::serial(left.constFirst())));
    if (left.isEmpty()) {
        end();
        if (first != 0 && isInService()) {
            m_before = report.join(u'\n');
            showFoundAt(first);
        }
        return;
    }
    const quint32 serial = left.constFirst();
    run([service = m_service, serial](Line &line) { return service.find(line, serial); },
        [this, left, report, first, serial](const Result<int> &found) {
            const bool isLost = !isInService() || (!found && isLineFault(found.fault()));
            const int address = found ? *found : everybody;
            if (address != everybody) {
                scan()->add(address);
            }
            findNext(
                isLost ? QList<quint32>() : left.sliced(1), report + QStringList{usmtext::place(serial, found)},
                first != 0 ? first : address);
        });
}

void UsmDialog::measure()
{
    if (begin(Task::Measure)) {
        const qint64 timestamp = m_form->device()->isStored() ? QDateTime::currentSecsSinceEpoch() : 0;
        m_form->device()->showValue(channelX, {});
        m_form->device()->showValue(channelY, {});
        say(tr("The device measures…"));
        measureChannel(channelX, timestamp);
    }
}

void UsmDialog::measureChannel(int channel, qint64 timestamp)
{
    run([service = m_service, to = address(), channel,
         timestamp](Line &line) { return service.measure(line, to, channel, timestamp); },
        [this, channel, timestamp](const Result<Value> &value) {
            m_form->device()->showValue(channel, value);
            if (channel == channelX && isInService()) {
                measureChannel(channelY, timestamp);
                return;
            }
            end();
            const bool isKept = timestamp != 0 && value && value->timestamp == timestamp;
            say(isKept ? tr("The device keeps what it measured.") : QString());
        });
}

} // namespace gorizont
