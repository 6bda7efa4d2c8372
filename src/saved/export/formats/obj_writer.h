// Writes an exported scene as a Wavefront OBJ file with its materials and images beside it: FILE.mtl and
// FILE_N.png for FILE.obj. Colours of vertices follow their positions ("v x y z r g b"). Any thread.
#pragma once
#include "base/files.h"
#include "saved/export/gather/exported_scene.h"

#include <string>

namespace gluray::saved {

/// Writes the first view into the draft of `file`, and the other files, and places all of them at the end.
/// Returns as writeGlb() does; errors of the other files, too.
std::string writeObj(const ExportedScene&, const std::string& file, files::Draft&);

}  // namespace gluray::saved
