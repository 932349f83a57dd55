#pragma once

#include "core/line/line.h"
#include "core/station/service/station.h"

#include <condition_variable>
#include <memory>
#include <mutex>

namespace gorizont::station {

/// A Line whose other end is a station of the same process (`Device=station:DIR`). Drivers do not know: bytes go to the station's
/// thread, what it answers comes back. The station must live longer than the line, its thread need not.
class StationLine : public Line
{
public:
    /// \a problem: why the station cannot be asked, in one sentence; empty: it can.
    StationLine(Station &station, const QString &problem, std::chrono::milliseconds pauseTick);
    ~StationLine() override;

    Result<void> open() override;
    void close() override { m_isOpen = false; }
    bool isOpen() const override { return m_isOpen; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override;
    Result<QByteArray> readSome(std::chrono::microseconds timeout) override;

private:
    /// What both threads see; outlives whichever of them ends first.
    struct Wire
    {
        explicit Wire(Station &station);

        Answerer answerer; ///< of the station's thread, as the listener
        RequestListener listener;
        std::mutex mutex;
        std::condition_variable arrived;
        QByteArray toHost; ///< under the mutex
    };

    Station &m_station;
    std::shared_ptr<Wire> m_wire;
    QString m_problem;
    bool m_isOpen = false;
};

} // namespace gorizont::station
