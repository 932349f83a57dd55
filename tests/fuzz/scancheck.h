#pragma once

#include "tests/support/scanning.h"

#include <cstdio>
#include <cstdlib>

namespace gorizont::fuzz {

/// Ends the program, so that the fuzzer keeps the input.
inline void require(bool isTrue, const char *what)
{
    if (!isTrue) {
        std::fprintf(stderr, "violated: %s\n", what);
        std::abort();
    }
}

/// \a scan, and the end of the program as soon as it breaks the contract of scan.h.
inline ScanFunction checked(const ScanFunction &scan)
{
    return [scan](QByteArrayView bytes) {
        const Scan found = scan(bytes);
        require(found.skip >= 0 && found.length >= 0, "no negative sizes");
        require(found.skip + found.length <= bytes.size(), "nothing beyond what was received");
        require((found.length == 0) == (found.state == Scan::State::Incomplete), "only a frame has a length");
        return found;
    };
}

/// The answer that a line would take out of \a bytes, for codecs where it must not depend on how a stream is cut into
/// pieces.
inline std::optional<QByteArray> sameAnswerInPieces(const ScanFunction &scan, const QByteArray &bytes)
{
    const auto whole = test::answerIn(checked(scan), bytes);
    require(test::answerIn(checked(scan), bytes, 1) == whole, "the same answer byte by byte");
    require(test::answerIn(checked(scan), bytes, 7) == whole, "the same answer in pieces of seven");
    return whole;
}

} // namespace gorizont::fuzz
