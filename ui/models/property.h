#pragma once

#include <QList>
#include <QString>

namespace gorizont {

/// One row of a page that describes one thing: its name, its value and what else is worth saying.
struct Property
{
    QString name;
    QString value;
    QString note = {}; ///< what the entry means, or that its value was replaced
    bool isSection = false; ///< a heading: only the name counts
    bool isReplaced = false; ///< the ini gave something else that could not be used

    static Property section(const QString &title) { return {title, {}, {}, true}; }

    bool operator==(const Property &) const = default;
};

using Properties = QList<Property>;

} // namespace gorizont
