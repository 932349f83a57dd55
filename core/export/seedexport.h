#pragma once

#include "core/export/exportjob.h"
#include "core/export/seednotes.h"
#include "core/export/seedpacker.h"

namespace gorizont {

/// The export of the samples of accelerometers. In the thread of runExport().
class SeedExport : public ExportJob
{
public:
    using ExportJob::ExportJob;

protected:
    bool writeAll() override;
    bool writeNotes() override;

private:
    bool writeSensor(int number, double before, double total);
    bool writeBlock(const SampleBlock &block, SeedPacker &x, SeedPacker &y);

    QList<SeedScale> m_scales;
};

} // namespace gorizont
