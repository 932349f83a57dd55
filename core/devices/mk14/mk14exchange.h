#pragma once

#include "core/line/line.h"
#include "core/protocol/ackmessages.h"
#include "core/values/timing.h"

namespace gorizont::mk14 {

/// How long \a bytes are on the wire of \a line at 11 bits a byte; 0 where the line does not know its speed.
std::chrono::milliseconds wireTime(const Line &line, qsizetype bytes);

/// Asks \a question with the control word that has to stand, waits TORCom beyond the time that question and answer are on the wire,
/// and gives the content of the answer. \a quietBefore: silence that has to be before, in case a late answer is still coming.
Result<ack::Answer> ask(
    Line &line, const ack::Question &question, quint32 outputs, const Timing &timing,
    std::chrono::microseconds quietBefore = {});

} // namespace gorizont::mk14
