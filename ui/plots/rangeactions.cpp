#include "ui/plots/rangeactions.h"

#include <QAction>

#include <array>

namespace gorizont {

namespace {

using namespace std::chrono_literals;

struct Range
{
    const char *title;
    std::chrono::seconds span;
};

constexpr std::array<Range, 6> ranges{{
    {QT_TRANSLATE_NOOP("gorizont::RangeActions", "10 min"), 10min},
    {QT_TRANSLATE_NOOP("gorizont::RangeActions", "1 h"), 1h},
    {QT_TRANSLATE_NOOP("gorizont::RangeActions", "1 day"), 24h},
    {QT_TRANSLATE_NOOP("gorizont::RangeActions", "1 week"), 24h * 7},
    {QT_TRANSLATE_NOOP("gorizont::RangeActions", "1 month"), 24h * 30},
    {QT_TRANSLATE_NOOP("gorizont::RangeActions", "1 year"), 24h * 365},
}};

} // namespace

RangeActions::RangeActions(QObject *parent, std::chrono::seconds longest)
    : QActionGroup(parent)
{
    setExclusionPolicy(ExclusionPolicy::ExclusiveOptional);
    for (const Range &range : ranges) {
        if (range.span > longest) {
            break;
        }
        QAction *action = addAction(tr(range.title));
        action->setObjectName(QStringLiteral("range%1").arg(range.span.count()));
        action->setCheckable(true);
        action->setData(qint64(range.span.count()));
    }
    connect(this, &QActionGroup::triggered, this, [this](QAction *action) {
        action->setChecked(true); // a second click does not let go
        Q_EMIT chosen(std::chrono::seconds(action->data().toLongLong()));
    });
}

void RangeActions::setShown(std::chrono::microseconds span)
{
    for (QAction *action : actions()) {
        const std::chrono::microseconds own = std::chrono::seconds(action->data().toLongLong());
        const std::chrono::microseconds difference = own > span ? own - span : span - own;
        action->setChecked(difference < own / 1000);
    }
}

} // namespace gorizont
