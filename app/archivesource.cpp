#include "app/archivesource.h"

#include "core/archive/archivereader.h"

namespace gorizont {

ArchiveSource archiveSource(ArchiveReader &archive)
{
    ArchiveSource source;
    source.gaps = [&archive](const QList<int> &numbers, UtcTime from, UtcTime to) {
        return archive.gaps(numbers, from, to);
    };
    source.completeness = [&archive](const QList<int> &numbers, QDate first, QDate last) {
        return archive.completeness(numbers, first, last);
    };
    source.events = [&archive](UtcTime from, UtcTime to, int most) { return archive.events(from, to, most); };
    source.series = archive.source();
    source.blocks = [&archive](int number, UtcTime from, UtcTime to) { return archive.blocks(number, from, to); };
    return source;
}

} // namespace gorizont
