#include "ui/service/changetext.h"

#include "ui/models/valuetext.h"
#include "ui/service/servicetext.h"

#include <QCoreApplication>

namespace gorizont::changetext {

namespace {

using and3::AddressStep;

class ChangeText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::ChangeText)
};

/// Before anything was stored.
QString earlyFailure(const and3::AddressChange &change, int to)
{
    const QString why = servicetext::fault(change.result.fault());
    switch (change.step) {
    case AddressStep::Probe:
        return change.result.fault() == Fault::Refused
            ? ChangeText::tr("the new address %1 is taken; nothing was stored. Scan again.").arg(to)
            : ChangeText::tr("asking the sensor before the change failed (%1); nothing was stored").arg(why);
    case AddressStep::Copy: return ChangeText::tr("copying the configuration failed (%1); nothing was stored").arg(why);
    case AddressStep::Check:
        return ChangeText::tr("checking the copied configuration failed (%1); nothing was stored").arg(why);
    case AddressStep::Set:
        return ChangeText::tr("setting the new address %2 failed (%1); nothing was stored").arg(why).arg(to);
    default: break;
    }
    return ChangeText::tr("checking the new address %2 failed (%1); nothing was stored").arg(why).arg(to);
}

} // namespace

QList<ind3::Changes> oneByOne(const ind3::Changes &all)
{
    QList<ind3::Changes> list;
    const auto append = [&](auto setting) {
        if (all.*setting) {
            ind3::Changes one;
            one.*setting = all.*setting;
            list.append(one);
        }
    };
    append(&ind3::Changes::name);
    append(&ind3::Changes::offset);
    append(&ind3::Changes::ticks);
    append(&ind3::Changes::period);
    return list;
}

QString setting(const ind3::Changes &change)
{
    if (change.name) {
        return ChangeText::tr("name “%1”").arg(*change.name);
    }
    if (change.offset) {
        return ChangeText::tr("zero offset X %1″, Y %2″")
            .arg(valuetext::fixed(change.offset->x, 3), valuetext::fixed(change.offset->y, 3));
    }
    return change.ticks ? ChangeText::tr("averaging ticks %1").arg(*change.ticks)
                        : ChangeText::tr("averaging period %1 ms").arg(change.period->count());
}

QString outcome(const Result<void> &written)
{
    if (written) {
        return ChangeText::tr("written");
    }
    switch (written.fault()) {
    case Fault::Refused: return ChangeText::tr("not written, the sensor does not take it");
    case Fault::BadReply: return ChangeText::tr("not written, the sensor still has another value");
    default: break;
    }
    return ChangeText::tr("%1: whether it was written is not known, check it").arg(servicetext::fault(written.fault()));
}

QString failure(const and3::AddressChange &change, int to)
{
    const QString why = servicetext::fault(change.result.fault());
    switch (change.step) {
    case AddressStep::Store:
        return ChangeText::tr("storing the new address %2 failed (%1); whether it was stored is not known. Write again "
                              "before a reset.")
            .arg(why)
            .arg(to);
    case AddressStep::VerifyStored:
        return ChangeText::tr("the new address %2 was stored, but checking the stored configuration failed (%1). Write "
                              "again before a reset.")
            .arg(why)
            .arg(to);
    default: break;
    }
    return earlyFailure(change, to);
}

} // namespace gorizont::changetext
