#pragma once

#include <QString>

namespace gorizont {

/// What the words and codes in the registers mean, as Markdown: the same for every configuration.
QString registerCodes();

} // namespace gorizont
