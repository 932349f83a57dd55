#include "tests/support/scanning.h"

namespace gorizont::test {

std::optional<QByteArray> answerIn(const ScanFunction &scan, const QByteArray &bytes, qsizetype size)
{
    const qsizetype step = size > 0 ? size : std::max<qsizetype>(bytes.size(), 1);
    QByteArray received;
    for (qsizetype at = 0; at < bytes.size(); at += step) {
        received += bytes.mid(at, step);
        for (;;) {
            const Scan found = scan(received);
            if (found.state == Scan::State::Complete) {
                return received.mid(found.skip, found.length);
            }
            if (found.skip + found.length == 0) {
                break;
            }
            received.remove(0, found.skip + found.length);
        }
    }
    return std::nullopt;
}

QStringList brokenProperties(const ScanFunction &scan, const QByteArray &answer, const QByteArray &garbage)
{
    QStringList broken;
    for (qsizetype size = 0; size < answer.size(); ++size) {
        if (scan(answer.left(size)) != Scan::incomplete()) {
            broken.append(QStringLiteral("a prefix of %1 bytes is not Incomplete").arg(size));
        }
        const QByteArray brokenOff = answer.left(size) + answer;
        if (answerIn(scan, brokenOff) != answer || answerIn(scan, brokenOff, 1) != answer) {
            broken.append(QStringLiteral("not found after its own first %1 bytes").arg(size));
        }
    }
    if (scan(answer) != Scan::complete(0, answer.size())) {
        broken.append(QStringLiteral("the whole is not Complete"));
    }
    for (const qsizetype size : {0, 1, 2, 3, 5}) {
        if (answerIn(scan, garbage + answer, size) != answer) {
            broken.append(QStringLiteral("not found after garbage in pieces of %1").arg(size));
        }
    }
    return broken;
}

QStringList unguardedBits(const ScanFunction &scan, const QByteArray &answer)
{
    QStringList unguarded;
    for (qsizetype byte = 0; byte < answer.size(); ++byte) {
        for (int bit = 0; bit < 8; ++bit) {
            QByteArray damaged = answer;
            damaged[byte] = static_cast<char>(damaged.at(byte) ^ (1 << bit));
            if (answerIn(scan, damaged) || answerIn(scan, damaged, 1)) {
                unguarded.append(QStringLiteral("%1.%2").arg(byte).arg(bit));
            }
        }
    }
    return unguarded;
}

} // namespace gorizont::test
