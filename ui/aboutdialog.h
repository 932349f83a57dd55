#pragma once

class QWidget;

namespace gorizont {

/// Name, version and licence of the program. Returns when it is closed.
void showAbout(QWidget *parent);

} // namespace gorizont
