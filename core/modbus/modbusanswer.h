#pragma once

#include "core/modbus/unitimages.h"
#include "core/net/answers.h"

namespace gorizont {

/// Appends to \a answers one answer for each whole request in \a received, in their order. Pure but for the
/// clocks of unit 1, which show the moment of the answer.
/// Checked in this order (Modbus Application Protocol 1.1b3, section 6.4; spec/gorizont.md, section 6): the unit is
/// known (exception 0B), the function is 04, in unit 1 also 03 (01), the request is 5 bytes long and asks for 1…125
/// registers (03), all of them exist (02).
AnsweredRequests answerRequests(QByteArrayView received, const UnitImages &images, AnswerBuffer &answers);

} // namespace gorizont
