#pragma once

#include "core/values/lineconfig.h"

#include <QString>

#include <memory>

namespace gorizont {

/// The building of `--demo`. Where the system has ptys, its ports are real ttys in a folder of their own, so that the
/// demonstration takes the same way as a site does: serial port, wire protocol, driver. Elsewhere the lines are simulated
/// inside the program. The sensors live in a thread of their own; main thread owns it.
class DemoSite
{
public:
    /// Gives each of \a lines the device where its sensors are.
    explicit DemoSite(QList<LineConfig> &lines);
    ~DemoSite();
    DemoSite(const DemoSite &) = delete;
    DemoSite &operator=(const DemoSite &) = delete;

private:
    struct Ports;
    std::unique_ptr<Ports> m_ports;
};

} // namespace gorizont
