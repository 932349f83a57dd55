#include "ui/plots/hodograph.h"

namespace gorizont {

namespace {

bool liesBetween(const QList<TimeSpan> &gaps, qsizetype &next, UtcTime until, std::chrono::microseconds step)
{
    bool isFound = false;
    for (; next < gaps.size() && gaps.at(next).from < until; ++next) {
        isFound = isFound || gaps.at(next).to - gaps.at(next).from >= step;
    }
    return isFound;
}

} // namespace

QList<HodographPoint> hodograph(const Series &x, const Series &y)
{
    QList<HodographPoint> points;
    qsizetype gapX = 0;
    qsizetype gapY = 0;
    qsizetype other = 0;
    bool isJoined = false;
    UtcTime last;
    for (const SeriesBucket &bucket : x.buckets) {
        while (other < y.buckets.size() && y.buckets.at(other).from < bucket.from) {
            ++other;
        }
        const bool isPair = other < y.buckets.size() && y.buckets.at(other).from == bucket.from && bucket.valid > 0
            && y.buckets.at(other).valid > 0;
        const bool hasGapX = liesBetween(x.gaps, gapX, bucket.from, x.step);
        const bool hasGapY = liesBetween(y.gaps, gapY, bucket.from, y.step);
        const bool isMissing = x.step.count() > 0 && bucket.from - last > x.step + x.step / 2;
        isJoined = isJoined && !hasGapX && !hasGapY && !isMissing;
        last = bucket.from;
        if (!isPair) {
            isJoined = false;
            continue;
        }
        points.append({bucket.from, QPointF(bucket.mean, y.buckets.at(other).mean), isJoined});
        isJoined = true;
    }
    return points;
}

} // namespace gorizont
