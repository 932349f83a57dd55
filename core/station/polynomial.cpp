#include "core/station/polynomial.h"

namespace gorizont::station {

double polynomial(const QList<double> &coefficients, double x)
{
    double sum = 0;
    for (qsizetype i = coefficients.size(); i-- > 0;) {
        sum = sum * x + coefficients[i];
    }
    return sum;
}

double converted(const Conversion &conversion, const Limits &limits, double error, double x)
{
    if (!conversion.isThreshold()) {
        return polynomial(conversion.coefficients, x - conversion.origin);
    }
    const double threshold = conversion.coefficients.first();
    const double left = limits.left.value_or(0);
    const double right = limits.right.value_or(1);
    if (x >= threshold + error) {
        return right;
    }
    return x <= threshold - error ? left : (left + right) / 2;
}

} // namespace gorizont::station
