#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>

#include <cstdio>
#include <cstdlib>
#include <optional>

namespace gorizont::fuzz {

/// Ends the program, so that the fuzzer keeps the input.
inline void require(bool isTrue, const char *what)
{
    if (!isTrue) {
        std::fprintf(stderr, "violated: %s\n", what);
        std::abort();
    }
}

/// What Line::exchange() would take as the answer if \a bytes arrived in pieces of \a size bytes; nothing if it would go
/// on waiting. Ends the program when \a scan breaks the contract of scan.h.
inline std::optional<QByteArray> answerIn(const ScanFunction &scan, const QByteArray &bytes, qsizetype size)
{
    QByteArray received;
    for (qsizetype at = 0; at < bytes.size(); at += size) {
        received += bytes.mid(at, size);
        for (;;) {
            const Scan found = scan(received);
            require(found.skip >= 0 && found.length >= 0, "no negative sizes");
            require(found.skip + found.length <= received.size(), "nothing beyond what was received");
            require((found.length == 0) == (found.state == Scan::State::Incomplete), "only a frame has a length");
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

/// For codecs whose answer must not depend on how a stream is cut into pieces.
inline std::optional<QByteArray> sameAnswerInPieces(const ScanFunction &scan, const QByteArray &bytes)
{
    const auto whole = answerIn(scan, bytes, std::max<qsizetype>(bytes.size(), 1));
    require(answerIn(scan, bytes, 1) == whole, "the same answer byte by byte");
    require(answerIn(scan, bytes, 7) == whole, "the same answer in pieces of seven");
    return whole;
}

} // namespace gorizont::fuzz
