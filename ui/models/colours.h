#pragma once

#include <QColor>

class QPalette;

namespace gorizont {

/// Colours that follow from the palette of the desktop, light or dark. Pure but for the palette of the application.
namespace colours {

bool isDark(const QPalette &palette);

/// For what matters less than the rest: the colour of text, nearer to its background. QPalette::PlaceholderText would
/// do, but several dark themes leave it black.
QColor mutedText(const QPalette &palette);
QColor mutedText(); ///< in the palette of the application

} // namespace colours

} // namespace gorizont
