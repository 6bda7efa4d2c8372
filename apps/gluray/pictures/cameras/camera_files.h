// Files with cameras: JSON of GLuRay's own (docs/guide/pictures.md), and ParaView's .pvcc and .pvsm. Any
// thread.
#pragma once
#include "pictures/cameras/camera_path.h"

#include <string>
#include <vector>

namespace gluray::launcher {

/// Reads one .json or .pvsm file, or .pvcc files with one key camera each. Throws std::runtime_error with one
/// line.
CameraPath readCameraPath(const std::vector<std::string>& files);

/// Reads a file with one camera: .json or .pvcc. Throws std::runtime_error with one line.
PathCamera readCamera(const std::string& file);

}  // namespace gluray::launcher
