// Intel Open Image Denoise, loaded while the program runs. Any thread.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace gluray::frame {

/// The functions that GLuRay calls, as the documentation of versions 1.4 and 2 describes them.
struct OidnLibrary {
  using Device = struct OidnDeviceHandle*;
  using Filter = struct OidnFilterHandle*;
  static constexpr int kCpu = 1;     // type of a device
  static constexpr int kFloat3 = 3;  // format of an image

  Device (*newDevice)(int type) = nullptr;
  void (*setDeviceInt)(Device, const char* name, int value) = nullptr;
  void (*setDeviceBool)(Device, const char* name, bool value) = nullptr;
  void (*commitDevice)(Device) = nullptr;
  void (*releaseDevice)(Device) = nullptr;
  /// 0: no error since the last call. Without a device: an error of the calling thread.
  int (*deviceError)(Device, const char** message) = nullptr;
  Filter (*newFilter)(Device, const char* type) = nullptr;
  void (*setImage)(Filter, const char* name, void* pixels, int format, size_t width, size_t height,
                   size_t offset, size_t pixelStride, size_t rowStride) = nullptr;
  void (*setFilterBool)(Filter, const char* name, bool value) = nullptr;
  void (*commitFilter)(Filter) = nullptr;
  void (*executeFilter)(Filter) = nullptr;
  void (*releaseFilter)(Filter) = nullptr;
};

/// Where the library may be.
struct OidnPlaces {
  std::string given;    // a file, or a folder with the library in it or in its lib; empty: look elsewhere
  std::string conda;    // root of the conda environment; empty: none
  std::string program;  // folder of the program's executable; empty: unknown
};

/// Those of this process: GLURAY_OIDN, CONDA_PREFIX, /proc/self/exe.
OidnPlaces oidnPlaces();

/// File names to load, in order. Names without a slash are searched for by the dynamic linker.
std::vector<std::string> oidnFiles(const OidnPlaces&);

/// Loads the first library that has all functions; it stays loaded. Returns false, with a reason in `why`,
/// if there is none. Throws std::bad_alloc.
bool loadOidn(const OidnPlaces&, OidnLibrary& library, std::string& why);

/// The library of this process, searched for once. Null, with a reason in `why`, if there is none. Throws
/// std::bad_alloc.
const OidnLibrary* oidnLibrary(std::string& why);

}  // namespace gluray::frame
