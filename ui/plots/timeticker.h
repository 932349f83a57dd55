#pragma once

#include "ui/plots/plotting.h"

namespace gorizont {

/// Ticks at round local times, with as much of the date as the span needs. Pure.
class TimeTicker : public QCPAxisTickerDateTime
{
public:
    void generate(
        const QCPRange &range, const QLocale &locale, QChar formatChar, int precision, QVector<double> &ticks,
        QVector<double> *subTicks, QVector<QString> *tickLabels) override;

protected:
    double getTickStep(const QCPRange &range) override;
};

} // namespace gorizont
