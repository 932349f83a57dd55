#include "core/station/service/requestlistener.h"
#include "core/station/sources/recordedsource.h"
#include "core/station/sources/sourcefile.h"

#include <cstdlib>

using namespace gorizont;
using namespace gorizont::station;

namespace {

void require(bool condition)
{
    if (!condition) {
        std::abort();
    }
}

/// What is heard does not depend on the pieces in which it comes, and is never to another station.
void listen(const QByteArray &bytes)
{
    const SteadyTime now{std::chrono::hours(1)};
    const auto isOwn = [](quint8 address) { return address == 1; };
    RequestListener whole(isOwn, std::chrono::milliseconds(1));
    RequestListener pieces(isOwn, std::chrono::milliseconds(1));
    const QList<ack::Asked> heard = whole.hear(bytes, now);
    QList<ack::Asked> heardInPieces;
    for (const char byte : bytes) {
        heardInPieces += pieces.hear(QByteArrayView(&byte, 1), now);
    }
    require(heard == heardInPieces);
    for (const ack::Asked &asked : heard) {
        require(asked.address == 1 && asked.command != 0);
    }
    // A silence later the station is not deaf, whatever was said. The frame was made with Python's struct.
    const QByteArray request = QByteArray::fromHex("bb0101000000000043");
    require(whole.hear(request, now + std::chrono::seconds(2)).size() == 1);
}

void readFiles(const QByteArray &bytes)
{
    Complaints complaints;
    const SourcePlan plan = readSources(QStringLiteral("ACK.SRC"), bytes, QStringLiteral("/station"), complaints);
    require(plan.rate > 0 && plan.rate <= SourcePlan::fastest);
    for (const StationComplaint &complaint : complaints.list()) {
        require(!complaint.text().isEmpty());
    }
    QString problem;
    const auto recording = readRecording(bytes, &problem);
    require(recording.has_value() == problem.isEmpty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    listen(bytes);
    readFiles(bytes);
    return 0;
}
