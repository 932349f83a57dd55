#pragma once

class QWidget;

namespace gorizont {

/// Name, version and licence of the program. Returns at once.
void showAbout(QWidget *parent);

} // namespace gorizont
