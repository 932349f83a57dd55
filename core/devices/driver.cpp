#include "core/devices/driver.h"

namespace gorizont {

Driver::~Driver() = default;

Result<QList<SampleBlock>> Driver::fetch(Line &)
{
    return QList<SampleBlock>();
}

} // namespace gorizont
