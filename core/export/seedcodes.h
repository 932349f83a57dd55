#pragma once

#include <QString>

namespace gorizont {

/// How the channels of a site are called in miniSEED (SEED manual 2.4, chapter 8 and appendix A). The band code of 10
/// samples a second and a response down to 0 Hz is B, the instrument code of an accelerometer N; X and Y of a building
/// point neither north nor east, and orthogonal components in other directions are 1 and 2.
struct SeedCodes
{
    QString network = QStringLiteral("XX"); ///< 1…2 letters or digits; XX: not registered
    QString station; ///< 1…5 letters or digits
    QString channelX = QStringLiteral("BN1"); ///< 3 letters or digits
    QString channelY = QStringLiteral("BN2");
    bool operator==(const SeedCodes &) const = default;
};

/// All codes have their lengths and hold nothing but A…Z and 0…9.
bool isValid(const SeedCodes &codes);

/// The first five letters and digits of the name of a site, Russian ones in Latin spelling; `SITE` if it has none.
QString seedStation(const QString &siteName);

/// 1…99 → `01`…`99`, 100…359 → `A0`…`Z9`, 360…1035 → `AA`…`ZZ`; empty: there is no code for this \a number.
QString seedLocation(int number);

} // namespace gorizont
