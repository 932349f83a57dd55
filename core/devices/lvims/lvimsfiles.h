#pragma once

#include "core/values/captureformat.h"

/// Captures as files: the formats stand with the values, because the history writes them too.
namespace gorizont::lvims {

using gorizont::spectrumCsv;
using gorizont::waveformCsv;
using gorizont::waveformWav;

} // namespace gorizont::lvims
