#pragma once

#include "core/adc24/adc24image.h"
#include "core/net/answers.h"

namespace gorizont {

/// ADC24 TCP (spec/gorizont.md, section 7: observed, no document exists). Every field little-endian.
///
///     request        0         1         2      3      4        5        9        13
///                    ┌─────────┬─────────┬──────┬──────┬────────┬────────┬────────┐
///                    │ address │ command │  sm  │ type │ unused │ block  │  size  │
///                    └─────────┴─────────┴──────┴──────┴────────┴────────┴────────┘
///     command 1      0         1         2           6
///                    ┌─────────┬─────────┬───────────┐
///                    │ address │    1    │ available │
///                    └─────────┴─────────┴───────────┘
///     command 3      0         1         2        3        4        8        16       24
///                    ┌─────────┬─────────┬────────┬────────┬────────┬────────┬────────┬───────────┐
///                    │ address │    3    │element │ status │ count  │ scale  │  rate  │ samples … │
///                    └─────────┴─────────┴────────┴────────┴────────┴────────┴────────┴───────────┘
///     no such block  0         1         2                 4        8
///                    ┌─────────┬─────────┬─────────────────┬────────┐
///                    │ address │    3    │     status      │ count  │
///                    └─────────┴─────────┴─────────────────┴────────┘
///
/// address    1
/// sm, type   what they mean is not known; anything
/// block      uint32: sample number block × size is the first; 0 is the oldest in the ring
/// size       uint32, samples in a block: 0 stands for 1, more than 8192 for 8192
/// available  uint32, samples in the ring
/// element    type of a sample: 2, int16
/// status     of the sensor (manual 000, section 11.2): its high byte, or where no samples follow all of it
/// count      uint32, samples that follow: size, or 0 where the ring holds no more than `block` whole blocks
/// scale      float64, 1/8 arc-second
/// rate       float64, samples a second
namespace adc24 {
constexpr qsizetype requestSize = 13;
constexpr quint32 mostSamples = 8192; ///< in an answer
constexpr qsizetype headerSize = 24; ///< before the samples
} // namespace adc24

/// Appends to \a answers one answer for each request in \a received, in their order. Pure.
/// A TCP stream has no borders, so every 13 bytes are a request; what has another address or command gets no answer, and
/// the next one begins 13 bytes later. A wrong length shows by time only: the caller drops what stays incomplete.
AnsweredRequests answerAdc24(QByteArrayView received, const Adc24Image &image, AnswerBuffer &answers);

} // namespace gorizont
