#include "programs/doors.h"

#include "base/address_space.h"
#include "base/environment_variable.h"
#include "base/files.h"
#include "intercept/probe/real_vendor.h"
#include "settings/layers/layers.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

void set(const char* name, const std::string& value) { setenv(name, value.c_str(), 1); }

/// Puts `entry` in front of a colon-separated list unless the list has it.
void putFirst(const char* name, const std::string& entry) {
  const std::string list = environmentVariable(name);
  if ((":" + list + ":").find(":" + entry + ":") != std::string::npos) return;
  set(name, list.empty() ? entry : entry + ":" + list);
}

/// Sets the variable of each setting that an option chose, so that child processes inherit it.
/// GLURAY_COMMAND_LINE lists these settings, so that they can name the command line as their origin.
void passSettings(const CommandLine& line) {
  set("GLURAY_PID", std::to_string(getpid()));
  if (!line.config.empty()) set("GLURAY_CONFIG", fs::absolute(line.config).string());
  set("GLURAY_PROJECT", projectFileHere());
  set("GLURAY_PROGRAM", line.program.empty() ? "" : fs::path(line.program[0]).filename().string());
  std::string options;
  for (const auto& [name, value] : passedValues(line.settings)) {
    set(variableOf(*findSetting(name)).c_str(), value);
    options.append(name).append("=").append(value).append("\n");
  }
  set("GLURAY_COMMAND_LINE", options);
  // Removes an earlier run's report, which could be taken for this run's.
  if (const std::string report = line.settings.find("report"); !report.empty()) files::removeOld(report);
}

/// A problem if `library` is not in `directory`. Without it the program would run as if there were no GLuRay.
std::string unlessThere(const std::string& directory, const char* library) {
  std::error_code error;
  if (fs::exists(fs::path(directory) / library, error)) return "";
  return std::string(library) + " is missing in " + directory +
         ": install GLuRay again; gluray doctor lists what it needs";
}

std::string openVendorDoor(const std::string& directory) {
  const probe::RealVendors real = probe::findRealVendors();
  if (real.glx.empty() && real.egl.empty())
    return "no OpenGL driver for libglvnd was found; try --door preload";
  const char* const library = real.glx.empty() ? "libEGL_gluray.so.0" : "libGLX_gluray.so.0";
  if (std::string problem = unlessThere(directory, library); !problem.empty()) return problem;
  putFirst("LD_LIBRARY_PATH", directory);
  if (!real.glx.empty()) {
    set("__GLX_VENDOR_LIBRARY_NAME", "gluray");
    set("GLURAY_REAL_GLX", real.glx);
  }
  if (!real.egl.empty()) {
    set("__EGL_VENDOR_LIBRARY_FILENAMES", directory + "/gluray_egl.json");
    set("GLURAY_REAL_EGL", real.egl);
  }
  return "";
}

/// Why the engine can never be loaded below these limits, which the program cannot raise; empty: it may.
/// Doors would take a little of what the real OpenGL needs.
std::string shortAddressSpace() {
  const unsigned long long least = glurayLoadBytes();
  for (const auto which : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit;
    if (getrlimit(which, &limit) != 0 || limit.rlim_max == RLIM_INFINITY || limit.rlim_max >= least) continue;
    std::array<char, 128> why;
    std::snprintf(why.data(), why.size(), GLURAY_ADDRESS_SPACE_IS_SHORT, least >> 20);
    return why.data();
  }
  return "";
}

}  // namespace

std::string libraryDirectory() {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* way : {"../lib/gluray", "../../lib/gluray"}) {
    const fs::path candidate = (here / way).lexically_normal();
    if (fs::exists(candidate / "libgluray-engine.so", error)) return candidate;
  }
  return "";
}

Session sessionOf(const CommandLine& line) {
  passSettings(line);
  return sessionFromEnvironment([](const std::string&) {});
}

std::string openDoors(const CommandLine& line, const Program& program) {
  const std::string directory = libraryDirectory();
  if (directory.empty())
    return "GLuRay's libraries are missing beside " + fs::read_symlink("/proc/self/exe").string();
  if (program.setUid) return program.path + " is set-uid: the system does not let GLuRay see its calls";
  if (std::string why = shortAddressSpace(); !why.empty()) return why;
  passSettings(line);
  const auto openPreloadDoor = [&]() -> std::string {
    if (directory.find_first_of(" :") != directory.npos)
      return "LD_PRELOAD takes no name with a space or colon: move GLuRay out of " + directory;
    if (std::string problem = unlessThere(directory, "libgluray.so"); !problem.empty()) return problem;
    return putFirst("LD_PRELOAD", directory + "/libgluray.so"), "";
  };
  if (line.door == "preload") return openPreloadDoor();
  if (line.door == "vendor") return openVendorDoor(directory);
  // The vendor door, and the preload door too if some calls do not come through libglvnd.
  const std::string problem = openVendorDoor(directory);
  if (program.osMesa || program.bundledGl || !problem.empty()) return openPreloadDoor();
  return "";
}

}  // namespace gluray::launcher
