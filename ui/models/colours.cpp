#include "ui/models/colours.h"

#include <QGuiApplication>
#include <QPalette>

namespace gorizont::colours {

bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Base).lightness() < 128;
}

QColor mutedText(const QPalette &palette)
{
    constexpr float share = 0.62F; ///< of the colour of text: a contrast of 4.5 : 1 on white and on dark grey
    const QColor text = palette.color(QPalette::Text);
    const QColor base = palette.color(QPalette::Base);
    const auto mixed = [](float a, float b) { return share * a + (1 - share) * b; };
    return QColor::fromRgbF(
        mixed(text.redF(), base.redF()), mixed(text.greenF(), base.greenF()), mixed(text.blueF(), base.blueF()));
}

QColor mutedText()
{
    return mutedText(QGuiApplication::palette());
}

} // namespace gorizont::colours
