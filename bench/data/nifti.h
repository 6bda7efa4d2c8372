// Reads medical volumes in the NIfTI-1 format. Used by the demo; any thread.
#pragma once
#include "bench/data/volume.h"

#include <string>

namespace gluray::bench {

/// The first volume of a NIfTI-1 file, gzip-compressed or not, little endian, of 8, 16 or 32 bit integers or
/// floats, scaled by the header's slope and intercept; origin 0, spacing in the file's units (millimetres as
/// a rule). Throws std::runtime_error with one clear line where the file is unreadable, cut short or of
/// another kind. Source: NIfTI-1 data format, nifti1.h, 2007.
Volume readNifti(const std::string& path);

}  // namespace gluray::bench
