// Cameras in files of ParaView. Any thread.
#pragma once
#include "pictures/cameras/camera_path.h"

#include <string_view>

namespace gluray::launcher {

/// The camera of a .pvcc file, or of a view in a state file. Throws std::runtime_error with one line.
PathCamera readPvcc(std::string_view text);

/// The camera animation of a state file (.pvsm) in the mode "Interpolate Camera", as ParaView plays it in the
/// mode "Sequence". `saved` has the camera of the view. Throws std::runtime_error with one line, also for
/// other modes.
CameraPath readPvsm(std::string_view text);

}  // namespace gluray::launcher
