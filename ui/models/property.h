#pragma once

#include "ui/models/health.h"

#include <QList>
#include <QString>

#include <optional>

namespace gorizont {

/// One row of a page that describes one thing: its name, its value and what else is worth saying.
struct Property
{
    QString name;
    QString value;
    QString note = {}; ///< what the entry means
    QString key = {}; ///< where the ini gives it: `[Timers] TmRun`; empty: it does not
    QString replaced = {}; ///< a sentence, if the ini gave something that could not be used
    std::optional<Health> health = {}; ///< drawn beside the value
    bool isSection = false; ///< a heading: only the name counts

    static Property section(const QString &title)
    {
        Property heading{title, {}};
        heading.isSection = true;
        return heading;
    }

    bool operator==(const Property &) const = default;
};

using Properties = QList<Property>;

} // namespace gorizont
