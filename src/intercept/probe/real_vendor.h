// Finds the real OpenGL drivers that a program would use without GLuRay. Called by the launcher. Runs in a
// child process, because drivers and X servers may hang or crash.
#pragma once
#include <string>
#include <vector>

namespace gluray::probe {

struct RealVendors {
  std::string glx;  // libglvnd vendor name ("mesa") or library; empty: none found
  std::string egl;  // library of the EGL vendor; empty: none found
};

/// Finds the drivers of the X display (environment DISPLAY) and of EGL. Keeps an earlier choice in the
/// environment (__GLX_VENDOR_LIBRARY_NAME, __EGL_VENDOR_LIBRARY_FILENAMES, __EGL_VENDOR_LIBRARY_DIRS) unless
/// it names GLuRay. If the X server does not answer, it takes about two seconds at most.
RealVendors findRealVendors();

/// EGL vendor files (JSON) in the order in which libEGL reads them. `fileNames` and `directories` are
/// colon-separated, as in the environment variables; files named gluray_egl.json are left out.
std::vector<std::string> eglVendorFiles(const std::string& fileNames, const std::string& directories);

/// The library_path values in these files, colon-separated.
std::string eglVendorLibraries(const std::string& fileNames, const std::string& directories);

}  // namespace gluray::probe
