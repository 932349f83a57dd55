#pragma once

#include <QColor>

namespace gorizont::test {

/// Contrast of two colours as WCAG 2 defines it, 1 … 21; texts need 4.5.
double contrast(const QColor &a, const QColor &b);

} // namespace gorizont::test
