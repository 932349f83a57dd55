#include "core/opc/opcsample.h"

#include "core/values/statusword.h"

#include <cmath>

namespace gorizont {

namespace {

bool hasValue(const OpcValue &value)
{
    return !std::holds_alternative<std::monostate>(value);
}

/// A number that is none must not reach a client.
OpcFieldValue finite(const OpcFieldValue &field)
{
    const double *number = std::get_if<double>(&field.value);
    return number == nullptr || std::isfinite(*number) ? field : OpcFieldValue{{}, OpcQuality::SensorFailure};
}

/// The last value lives on; without one there is nothing to last.
OpcSample distrusted(const OpcSample &previous, OpcQuality overall)
{
    OpcSample next = previous;
    next.quality = overall == OpcQuality::LastKnown && !hasValue(previous.value) ? OpcQuality::CommFailure : overall;
    return next;
}

/// An answer without the field: it may come yet, or it came before and now fails.
OpcSample missing(const OpcSample &previous)
{
    OpcSample next = previous;
    next.quality = hasValue(previous.value) ? OpcQuality::SensorFailure : OpcQuality::WaitingForInitialData;
    return next;
}

} // namespace

OpcQuality opcQuality(const SensorConfig &sensor, const LineStatus &line, const Reading &reading)
{
    if (!sensor.isOn || (reading.status & statusbit::NotPolled)) {
        return OpcQuality::OutOfService;
    }
    switch (line.state) {
    case LineState::Off:
    case LineState::Service: return OpcQuality::OutOfService;
    case LineState::OpenFailed:
    case LineState::Lost: return OpcQuality::NotConnected;
    case LineState::Opening: return OpcQuality::WaitingForInitialData;
    case LineState::Open: break;
    }
    switch (statusCode(reading.status)) {
    case StatusCode::PortOff: return OpcQuality::OutOfService;
    case StatusCode::PortError: return OpcQuality::NotConnected;
    case StatusCode::NoAnswer:
    case StatusCode::CrcErrors: return OpcQuality::LastKnown;
    default: break;
    }
    const bool hasAnswered = reading.answeredAt && (!line.openedAt || *reading.answeredAt >= *line.openedAt);
    return hasAnswered ? OpcQuality::Good : OpcQuality::WaitingForInitialData;
}

OpcSample opcNext(
    const OpcSample &previous, OpcQuality overall, const OpcFieldValue &field, const Reading &reading, UtcTime time)
{
    const OpcFieldValue known = finite(field);
    OpcSample next;
    if (overall != OpcQuality::Good) {
        next = distrusted(previous, overall);
    } else if (!hasValue(known.value) && known.quality == OpcQuality::Good) {
        next = missing(previous);
    } else {
        next.value = hasValue(known.value) ? known.value : previous.value;
        next.quality = known.quality;
    }
    const bool isNews = next.value != previous.value || next.quality != previous.quality;
    const bool isConfirmed = reading.isAnswer && next.quality == OpcQuality::Good;
    next.time = isNews || isConfirmed ? time : previous.time;
    return next;
}

} // namespace gorizont
