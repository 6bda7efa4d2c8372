// How software is installed on this machine, and how GLuRay was: what `gluray doctor` advises.
#pragma once
#include <functional>
#include <string>

namespace gluray::launcher {

/// What advice depends on. Tests make their own.
struct Host {
  std::string ids;          // ID and ID_LIKE of /etc/os-release, a space between them
  bool isRoot = false;      // nobody else may install packages,
  bool hasSudo = false;     // but who may use sudo
  bool hasManager = false;  // the distribution's program for packages is there
};

/// This machine.
Host thisHost();

/// What to do about a library that is missing, by its name ("libGLU.so.1"): a command, or whom to ask for
/// what.
std::string adviceForLibrary(const std::string& name, const Host& host);

/// The same for OpenGL itself; `api`: "glx" or "egl".
std::string adviceForOpenGl(const std::string& api, const Host& host);

enum class Installed { archive, wheel, package, build, other };

/// How GLuRay came to be in the folder of its libraries, from the files beside it.
Installed howInstalled(const std::string& libraryDirectory);

/// "the archive", "the wheel in PREFIX" ...
std::string described(Installed how, const std::string& libraryDirectory);

/// How to remove it.
std::string adviceToRemove(Installed how, const std::string& libraryDirectory, const Host& host);

/// How to install it again.
std::string adviceToReinstall(Installed how, const Host& host);

}  // namespace gluray::launcher
