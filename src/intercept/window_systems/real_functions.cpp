#include "intercept/window_systems/real_functions.h"

#include "base/log.h"
#include "intercept/stubs/orphan_gl.h"

#include <array>
#include <atomic>
#include <mutex>
#include <string>

// Set by the linker: start and end of this library in memory.
extern "C" const char __ehdr_start __attribute__((visibility("hidden")));
extern "C" const char _end __attribute__((visibility("hidden")));

namespace gluray::intercept {
namespace {

std::array<std::atomic<const GlurayDoor*>, 3> g_doors;

bool isOurs(const void* function) {
  const auto address = reinterpret_cast<uintptr_t>(function);
  return address >= reinterpret_cast<uintptr_t>(&__ehdr_start) &&
         address < reinterpret_cast<uintptr_t>(&_end);
}

/// The door that provides the real OpenGL of `api`.
Door doorOf(Api api) {
  if (api == Api::glx && g_doors[kVendorGlx]) return kVendorGlx;
  if (api == Api::egl && g_doors[kVendorEgl]) return kVendorEgl;
  return kPreload;
}

struct LoadedGl {
  std::once_flag once;
  gl::RealGl table;
};

}  // namespace

thread_local int Outermost::depth_ = 0;

void openDoor(const GlurayDoor* door) {
  if (door->kind >= 0 && door->kind < static_cast<int>(g_doors.size())) g_doors[door->kind] = door;
}

const char* openDoorNames() {
  const bool vendor = g_doors[kVendorGlx] || g_doors[kVendorEgl];
  return !g_doors[kPreload] ? "vendor" : vendor ? "vendor and preload" : "preload";
}

void* realFunction(Door door, Api api, const char* name) {
  const GlurayDoor* opened = g_doors[door];
  void* function = opened ? opened->realProc(name, static_cast<int>(api)) : nullptr;
  if (!isOurs(function)) return function;
  log::once(log::Level::error, "real function is ours",
            std::string("the real ") + name +
                " is GLuRay's own: GLuRay is loaded twice, or is configured as the real OpenGL");
  return nullptr;
}

const gl::RealGl& realGl(Api api) {
  static std::array<LoadedGl, 3> loaded;  // never freed: trivially destructible
  LoadedGl& mine = loaded[static_cast<size_t>(api)];
  std::call_once(mine.once, [&] {
    const auto lookup = [](void* user, const char* name) {
      const Api wanted = *static_cast<Api*>(user);
      return realFunction(doorOf(wanted), wanted, name);
    };
    gl::loadRealGl(mine.table, lookup, &api);
    const gl::RealGl* none = nullptr;
    g_orphanGl.compare_exchange_strong(none, &mine.table);
  });
  return mine.table;
}

}  // namespace gluray::intercept
