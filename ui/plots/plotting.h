#pragma once

#include <QtPrintSupport>
#include <QtWidgets>

// QCustomPlot's header is written in Qt's keywords, which are switched off everywhere else.
#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach(variable, container) for (variable : container)
#include <qcustomplot.h>
#undef foreach
#undef slots
#undef signals
