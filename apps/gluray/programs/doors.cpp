#include "programs/doors.h"

#include "base/environment_variable.h"
#include "base/files.h"
#include "base/guarded_write.h"
#include "base/processes/address_space.h"
#include "intercept/probe/real_vendor.h"
#include "programs/door_files.h"
#include "programs/own_osmesa.h"
#include "programs/streams.h"
#include "settings/layers/settings_layers.h"

#include <sys/auxv.h>
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
  set(GLURAY_STREAMS, streamIdentities());
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

/// Puts our EGL vendor file before the machine's own: libEGL reads these where it cannot load ours, and the
/// door keeps it from loading the real vendor a second time.
void openEglDoor(const std::string& vendorFile) {
  std::string files = vendorFile;
  for (const std::string& file : probe::eglVendorFiles(environmentVariable("__EGL_VENDOR_LIBRARY_FILENAMES"),
                                                       environmentVariable("__EGL_VENDOR_LIBRARY_DIRS")))
    files.append(":").append(file);
  set("__EGL_VENDOR_LIBRARY_FILENAMES", files);
}

std::string openVendorDoor(const DoorFiles& files) {
  const probe::RealVendors real = probe::findRealVendors();
  if (real.glx.empty() && real.egl.empty())
    return "no OpenGL driver for libglvnd was found; try --door preload";
  const char* const library = real.glx.empty() ? "libEGL_gluray.so.0" : "libGLX_gluray.so.0";
  if (std::string problem = unlessThere(files.directory, library); !problem.empty()) return problem;
  putFirst("LD_LIBRARY_PATH", files.directory);
  if (!real.glx.empty()) {
    set("__GLX_VENDOR_LIBRARY_NAME", "gluray");
    set("GLURAY_REAL_GLX", real.glx);
  }
  if (!real.egl.empty() && !files.eglVendorFile.empty()) {
    openEglDoor(files.eglVendorFile);
    set("GLURAY_REAL_EGL", real.egl);
  }
  return "";
}

std::string openPreloadDoor(const DoorFiles& files) {
  if (std::string problem = unlessThere(files.directory, "libgluray.so"); !problem.empty()) return problem;
  return putFirst("LD_PRELOAD", files.directory + "/libgluray.so"), "";
}

}  // namespace

std::string launcherFile() {
  std::error_code error;
  if (const fs::path linked = fs::read_symlink("/proc/self/exe", error); !error) return linked;
  const auto* const started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  const fs::path named = started ? started : "";
  if (const fs::path real = fs::canonical(named, error); !error) return real;
  const fs::path whole = fs::absolute(named, error);
  return error ? named : whole.lexically_normal();
}

std::string libraryDirectory() {
  std::error_code error;
  const fs::path here = fs::path(launcherFile()).parent_path();
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

std::string openDoors(const CommandLine& line, const Program& program) {
  const std::string directory = libraryDirectory();
  if (directory.empty()) return "GLuRay's libraries are missing beside " + launcherFile();
  if (!program.privilege.empty()) return program.whyUnseen();
  // Doors alone would take a little of what the real OpenGL needs.
  if (std::string why = shortAddressSpace(); !why.empty()) return why;
  passSettings(line);
  const DoorFiles files = doorFiles(directory);
  if (files.directory.empty()) return files.why;
  if (const std::string folder = ownOsMesa(directory); !folder.empty()) putFirst("LD_LIBRARY_PATH", folder);
  if (line.door == "preload") return openPreloadDoor(files);
  if (line.door == "vendor") return openVendorDoor(files);
  // The vendor door, and the preload door too if some calls do not come through libglvnd.
  const std::string problem = openVendorDoor(files);
  if (program.osMesa || program.bundledGl || !problem.empty()) return openPreloadDoor(files);
  return "";
}

}  // namespace gluray::launcher
