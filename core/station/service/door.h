#pragma once

#include "core/protocol/ackmessages.h"
#include "core/station/service/requestlistener.h"

namespace gorizont::station {

/// Who answers what comes through a door. Empty: the station stays silent.
struct Answerer
{
    RequestListener::IsOwn isOwn;
    std::function<QByteArray(const ack::Asked &asked)> answer;
};

} // namespace gorizont::station
