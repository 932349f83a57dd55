#pragma once

#include "core/config/serverconfig.h"

#include <QString>

namespace gorizont {

/// The registers of every unit for exactly this configuration, as Markdown in the language of the program: every address
/// in both ways of counting, type, byte order, scale, unit, whose it is, and a request with its answer byte by byte.
/// Made from the tables and the images that answer the clients. Pure; some megabytes for hundreds of sensors.
QString registerDocument(const ServerConfig &server);

} // namespace gorizont
