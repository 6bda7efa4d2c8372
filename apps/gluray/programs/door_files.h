// The names by which programs load the doors. Lists such as LD_LIBRARY_PATH cannot hold every directory, and
// EGL's vendor file must name its library by an absolute path.
#pragma once
#include <string>

namespace gluray::launcher {

struct DoorFiles {
  std::string directory;      // of the libraries, by a name that every list can hold; empty: there is none
  std::string eglVendorFile;  // names the EGL door by its absolute path
  std::string why;            // there is no directory: one line
};

/// The files of the doors in `directory`. Uses the user's private directory (control/runtime_directory.h) for
/// a link if the directory's name has a character that a list cannot hold, and for a vendor file if the one
/// in `directory` names another place.
DoorFiles doorFiles(const std::string& directory);

/// Whether LD_LIBRARY_PATH, LD_PRELOAD, lists of EGL vendor files and dlopen take the name as it is.
bool isPlainName(const std::string& path);

}  // namespace gluray::launcher
