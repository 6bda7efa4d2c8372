// Writes an exported scene as a PLY file (binary, little endian): one mesh in world space, with the displayed
// colours of its vertices as bytes. Any thread.
#pragma once
#include "base/files.h"
#include "saved/export/gather/exported_scene.h"

#include <string>

namespace gluray::saved {

/// Writes the first view. Returns as writeGlb() does.
std::string writePly(const ExportedScene&, files::Draft&);

}  // namespace gluray::saved
