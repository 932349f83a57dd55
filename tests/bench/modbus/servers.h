#pragma once

namespace gorizont::bench {

/// A Modbus TCP server on a free port of 127.0.0.1; it prints the port on a line of its own and serves until it is killed.
struct Contender
{
    const char *name;
    int (*serve)(int argc, char **argv);
};

/// Ours in a thread of its own, as in the program.
int serveOurs(int argc, char **argv);
/// QModbusTcpServer with a map of input registers and nothing else.
int serveQt(int argc, char **argv);
/// libmodbus in a select() loop, as in its own examples.
int serveLibmodbus(int argc, char **argv);
/// epoll, read, look at the length, write: what the system itself costs.
int serveBare(int argc, char **argv);

constexpr Contender contenders[] = {
    {"ours", &serveOurs}, {"QModbusTcpServer", &serveQt}, {"libmodbus", &serveLibmodbus}, {"bare epoll", &serveBare}};

/// Tells whoever started this process the port.
void tellPort(int port);

} // namespace gorizont::bench
