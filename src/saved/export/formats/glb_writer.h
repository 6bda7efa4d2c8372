// Writes an exported scene as a binary glTF 2.0 file (Khronos, "glTF 2.0 Specification", 2021) with the
// extensions KHR_materials_unlit and KHR_lights_punctual. Any thread.
#pragma once
#include "base/files.h"
#include "saved/export/gather/exported_scene.h"

#include <string>

namespace gluray::saved {

/// Returns why nothing was written, beside errors of the draft; empty if there is no such reason. Throws
/// std::bad_alloc and std::runtime_error.
std::string writeGlb(const ExportedScene&, files::Draft&);

}  // namespace gluray::saved
