#pragma once

#include "core/protocol/ackmessages.h"
#include "core/station/stationpipeline.h"

namespace gorizont::station {

/// What a station says to the data command \a command, 1…8: the first \a count parameters of \a weather with the values that the
/// command asks for (manual 004, section 4.2), and for CMD 8 \a extras and the precipitation. Without a single value there are no
/// data: the answer has no parameters then.
ack::Answer answerOf(int command, const Weather &weather, qsizetype count, const WindExtras &extras);

/// The other way round: what an answer to \a command says, as far as it does; parameters get the identities of \a ids in order, and
/// numbers without a code behind them.
Weather weatherOf(int command, const ack::Answer &answer, const QList<std::optional<ParameterId>> &ids);
WindExtras extrasOf(const ack::Answer &answer);

} // namespace gorizont::station
