#pragma once

#include <QLabel>

namespace gorizont {

/// A value that is shown and can be copied, not changed. Has the room for \a widest from the start, so that nothing moves
/// when values come.
inline QLabel *valueLabel(const QString &objectName, const QString &widest, QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setObjectName(objectName);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest));
    return label;
}

} // namespace gorizont
