// Finds the real OpenGL drivers that a program would use without us. Called by the launcher; runs in a child
// process, because drivers and X servers may hang or crash.
#pragma once
#include <string>

namespace gluray::probe {

struct RealVendors {
  std::string glx;  // libglvnd vendor name ("mesa") or library; empty: none found
  std::string egl;  // library of the EGL vendor; empty: none found
};

/// Finds the drivers of the X display (environment DISPLAY) and of EGL. Keeps an earlier choice in the
/// environment (__GLX_VENDOR_LIBRARY_NAME, __EGL_VENDOR_LIBRARY_FILENAMES, __EGL_VENDOR_LIBRARY_DIRS) unless
/// it is ours. Takes at most about two seconds, if the X server does not answer.
RealVendors findRealVendors();

/// EGL vendor libraries in the order in which libEGL tries them: the library_path of each JSON file.
/// `fileNames` and `directories` are colon-separated, as in the environment variables.
std::string eglVendorLibraries(const std::string& fileNames, const std::string& directories);

}  // namespace gluray::probe
