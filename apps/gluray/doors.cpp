#include "doors.h"

#include "base/files.h"
#include "intercept/probe/real_vendor.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

void set(const char* name, const std::string& value) { setenv(name, value.c_str(), 1); }

/// Puts `entry` in front of a colon-separated list, once.
void putFirst(const char* name, const std::string& entry) {
  const std::string list = environment(name);
  if ((":" + list + ":").find(":" + entry + ":") != std::string::npos) return;
  set(name, list.empty() ? entry : entry + ":" + list);
}

void setIfGiven(const char* name, const std::string& value) {
  if (!value.empty()) set(name, value);
}

/// The program may change its directory: files are named absolutely.
std::string absolute(const std::string& file) {
  return file.empty() || files::isStream(file) ? file : fs::absolute(file).string();
}

void passSettings(const CommandLine& line) {
  set("GLURAY_PID", std::to_string(getpid()));
  setIfGiven("GLURAY_CONFIG", absolute(line.config));
  setIfGiven("GLURAY_THREADS", line.threads);
  setIfGiven("GLURAY_ENGINE", line.engine);
  setIfGiven("GLURAY_BVH", line.bvh);
  setIfGiven("GLURAY_SHADING", line.shading);
  setIfGiven("GLURAY_RENDERER", line.renderer);
  setIfGiven("GLURAY_SPP", line.spp);
  setIfGiven("GLURAY_LAG", line.lag);
  setIfGiven("GLURAY_REPORT", absolute(line.report));
  setIfGiven("GLURAY_TIMELINE", absolute(line.timeline));
  setIfGiven("GLURAY_LOG", absolute(line.log));
  setIfGiven("GLURAY_LOG_LEVEL", line.logLevel);
  if (line.hud) set("GLURAY_HUD", "1");
  if (line.off) set("GLURAY_OFF", "1");
  std::string quirks = environment("GLURAY_QUIRKS");  // later ones win
  for (const std::string& quirk : line.quirks) quirks += (quirks.empty() ? "" : ",") + quirk;
  setIfGiven("GLURAY_QUIRKS", quirks);
  std::string families;  // earlier ones win
  for (const std::string& file : line.programFamilies)
    families.append(families.empty() ? "" : ":").append(absolute(file));
  const std::string more = environment("GLURAY_PROGRAM_FAMILIES");
  if (!families.empty() && !more.empty()) families.append(":").append(more);
  setIfGiven("GLURAY_PROGRAM_FAMILIES", families);
  if (!line.report.empty())
    files::removeOld(line.report);  // a report of an earlier run must not pass for this one's
}

std::string openVendorDoor(const std::string& directory) {
  const probe::RealVendors real = probe::findRealVendors();
  if (real.glx.empty() && real.egl.empty())
    return "no OpenGL driver for libglvnd was found; try --door preload";
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
  if (program.setUid) return program.path + " is set-uid: the system lets nobody look into it";
  passSettings(line);
  const auto openPreloadDoor = [&]() -> std::string {
    if (directory.find_first_of(" :") != directory.npos)
      return "LD_PRELOAD takes no name with a space or colon: move GLuRay out of " + directory;
    return putFirst("LD_PRELOAD", directory + "/libgluray.so"), "";
  };
  if (line.door == "preload") return openPreloadDoor();
  if (line.door == "vendor") return openVendorDoor(directory);
  // The vendor door, and the other one too for what does not come through libglvnd.
  const std::string problem = openVendorDoor(directory);
  if (program.osMesa || program.bundledGl || !problem.empty()) return openPreloadDoor();
  return "";
}

}  // namespace gluray::launcher
