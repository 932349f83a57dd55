#pragma once

#include "core/devices/driver.h"
#include "core/devices/usmisn/usmisnprotocol.h"

#include <memory>

namespace gorizont::usmisn {

/// A device measures one channel for up to 1.5 s; its answer is waited for twice as long.
constexpr std::chrono::seconds measuringPatience{3};

/// What is said on a silent line: a device resets after 26 s in which it heard no message (manual 002, section 4). A
/// broadcast of GetSerial is a message that nobody answers (3.1.1).
KeepAlive watchdogFood();

/// The driver of one УСМ-ИСН: both channels in one turn, about 3 s, nothing stored in the device. The options `verifycrc`
/// (1: GetCRC is asked after each measurement) and `usmrevive` (0: a silent device is not helped by a silent line) are those of
/// the sensor.
std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::usmisn
