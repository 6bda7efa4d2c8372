#include "control/runtime_directory.h"

#include "base/environment_variable.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace gluray::control {
namespace {

constexpr mode_t kMode = 0700;

std::string reason(int error) { return std::error_code(error, std::generic_category()).message(); }

std::string withoutSlashes(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

}  // namespace

std::string runtimeDirectory() {
  if (std::string named = environmentVariable("GLURAY_RUNTIME"); !named.empty())
    return withoutSlashes(std::move(named));
  if (const std::string session = environmentVariable("XDG_RUNTIME_DIR"); !session.empty())
    return withoutSlashes(session) + "/gluray";
  return "/tmp/gluray-" + std::to_string(getuid());
}

std::string whyUnsafe(const std::string& directory) {
  struct stat status {};
  if (!directory.starts_with('/')) return directory + " is not an absolute path; set GLURAY_RUNTIME to one";
  if (lstat(directory.c_str(), &status) != 0) return directory + ": " + reason(errno);
  if (S_ISLNK(status.st_mode)) return directory + " is a symbolic link; remove it";
  if (!S_ISDIR(status.st_mode)) return directory + " is not a directory; remove it";
  if (status.st_uid != geteuid())
    return directory + " belongs to another user; set GLURAY_RUNTIME to a directory of yours";
  if ((status.st_mode & 0777) != kMode) {
    char mode[8];
    snprintf(mode, sizeof mode, "%03o", static_cast<unsigned>(status.st_mode & 0777));
    return directory + " has mode " + mode + "; run chmod 700 " + directory;
  }
  return "";
}

std::string makeRuntimeDirectory(const std::string& directory) {
  if (directory.starts_with('/') && mkdir(directory.c_str(), kMode) != 0 && errno != EEXIST)
    return directory + ": " + reason(errno) + "; set GLURAY_RUNTIME to a directory of yours";
  return whyUnsafe(directory);
}

}  // namespace gluray::control
