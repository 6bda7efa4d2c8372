#include "frame/refinement/oidn_library.h"

#include "base/environment_variable.h"

#include <dlfcn.h>

#include <filesystem>

namespace gluray::frame {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNames[] = {"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1"};

/// Finds functions of one library, and keeps the name of the first that it lacks.
struct Finder {
  void* library;
  const char* missing = nullptr;
  /// `older`: the name in version 1.4, if it differs.
  template <class Function>
  void find(Function& function, const char* name, const char* older = nullptr) {
    void* address = dlsym(library, name);
    if (!address && older) address = dlsym(library, older);
    if (!address && !missing) missing = name;
    function = reinterpret_cast<Function>(address);
  }
};

/// The name of the first function that the library lacks; null: none.
const char* findFunctions(void* handle, OidnLibrary& out) {
  Finder finder{handle};
  finder.find(out.newDevice, "oidnNewDevice");
  finder.find(out.setDeviceInt, "oidnSetDeviceInt", "oidnSetDevice1i");
  finder.find(out.setDeviceBool, "oidnSetDeviceBool", "oidnSetDevice1b");
  finder.find(out.commitDevice, "oidnCommitDevice");
  finder.find(out.releaseDevice, "oidnReleaseDevice");
  finder.find(out.deviceError, "oidnGetDeviceError");
  finder.find(out.newFilter, "oidnNewFilter");
  finder.find(out.setImage, "oidnSetSharedFilterImage");
  finder.find(out.setFilterBool, "oidnSetFilterBool", "oidnSetFilter1b");
  finder.find(out.commitFilter, "oidnCommitFilter");
  finder.find(out.executeFilter, "oidnExecuteFilter");
  finder.find(out.releaseFilter, "oidnReleaseFilter");
  return finder.missing;
}

bool isPath(const std::string& file) { return file.find('/') != std::string::npos; }

}  // namespace

OidnPlaces oidnPlaces() {
  std::error_code error;
  return {environmentVariable("GLURAY_OIDN"), environmentVariable("CONDA_PREFIX"),
          fs::read_symlink("/proc/self/exe", error).parent_path()};
}

std::vector<std::string> oidnFiles(const OidnPlaces& places) {
  std::vector<std::string> files;
  const auto add = [&](const fs::path& folder) {
    for (const char* name : kNames) files.push_back(folder / name);
  };
  if (!places.given.empty()) {
    std::error_code error;
    if (!fs::is_directory(places.given, error)) return {fs::absolute(places.given, error)};
    const fs::path folder = fs::absolute(places.given, error);
    add(folder), add(folder / "lib");
    add(folder / "oidn" / "lib");  // in the folder of the Python package pyoidn
    return files;
  }
  for (const char* name : kNames) files.emplace_back(name);
  if (!places.conda.empty()) add(fs::path(places.conda) / "lib");
  if (!places.program.empty()) {  // as ParaView's archives have it
    add(fs::path(places.program).parent_path() / "lib");
    add(places.program);
  }
  return files;
}

bool loadOidn(const OidnPlaces& places, OidnLibrary& library, std::string& why) {
  why = places.given.empty() ? "there is no libOpenImageDenoise.so.2; install it, or set GLURAY_OIDN to its "
                               "file or folder"
                             : "GLURAY_OIDN=" + places.given + " has no libOpenImageDenoise.so.2";
  for (const std::string& file : oidnFiles(places)) {
    std::error_code error;
    if (isPath(file) && !fs::exists(file, error)) continue;
    void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle) {
      const char* const message = dlerror();
      if (isPath(file)) why = "cannot load it: " + std::string(message ? message : file);
      continue;
    }
    const char* const missing = findFunctions(handle, library);
    if (!missing) return true;
    why = file + " has no function " + missing + "; versions 1.4 and 2 of Open Image Denoise do";
    dlclose(handle);
  }
  return false;
}

const OidnLibrary* oidnLibrary(std::string& why) {
  struct Loaded {
    OidnLibrary library;
    std::string why;
    bool found = loadOidn(oidnPlaces(), library, why);
  };
  static const Loaded loaded;
  if (!loaded.found) why = loaded.why;
  return loaded.found ? &loaded.library : nullptr;
}

}  // namespace gluray::frame
