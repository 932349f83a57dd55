#pragma once

#include <QByteArrayView>

#include <functional>

namespace gorizont {

/// What a codec finds in the bytes received so far. The bytes up to `skip` can never be part of the expected answer
/// (garbage, an echo, a late answer to somebody else) and are dropped; then:
///   Incomplete  keep the rest and wait for more;
///   Complete    `length` bytes after `skip` are the answer, envelope checked (length, header, check sum, echo);
///   Damaged     `length` bytes after `skip` look like the answer and their check sum is wrong.
struct Scan
{
    enum class State : quint8 { Incomplete, Complete, Damaged };

    State state = State::Incomplete;
    qsizetype skip = 0;
    qsizetype length = 0; ///< 0 when Incomplete

    static constexpr Scan incomplete(qsizetype skip = 0) { return {State::Incomplete, skip, 0}; }
    static constexpr Scan complete(qsizetype skip, qsizetype length) { return {State::Complete, skip, length}; }
    static constexpr Scan damaged(qsizetype skip, qsizetype length) { return {State::Damaged, skip, length}; }

    bool operator==(const Scan &) const = default;
};

/// Pure: looks at the bytes, touches no port. Made by a codec for one request, so that it knows what answer to expect.
using ScanFunction = std::function<Scan(QByteArrayView)>;

} // namespace gorizont
