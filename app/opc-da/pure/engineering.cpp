#include "app/opc-da/pure/engineering.h"

namespace opcda {

Scale scaleOf(const Tag &tag)
{
    if (tag.type != TagType::Double)
        return {};
    const Text leaf = splitName(tag.id).back();
    if (matches(u"Angl_[XY]", leaf))
        return {-3600, 3600, u"″"};
    if (matches(u"A???_[XY]", leaf))
        return {0, 10000, u"mm/s²"};
    if (matches(u"Temper*", leaf))
        return {-60, 100, u"°C"};
    return {};
}

} // namespace opcda
