// The open doors of this process and the real functions behind them. Any thread.
#pragma once
#include "gl/real/real.h"
#include "intercept/doors/door_abi.h"

namespace gluray::intercept {

/// The API that created a context; it determines the OpenGL library.
enum class Api { glx = GLURAY_API_GLX, egl = GLURAY_API_EGL, osmesa = GLURAY_API_OSMESA };

/// The kinds of doors, as template arguments: a hook forwards to the functions behind the door that called
/// it.
enum Door {
  kVendorGlx = GLURAY_DOOR_VENDOR_GLX,
  kVendorEgl = GLURAY_DOOR_VENDOR_EGL,
  kPreload = GLURAY_DOOR_PRELOAD
};

void openDoor(const GlurayDoor* door);
/// "vendor", "preload" or "vendor and preload", for the report.
const char* openDoorNames();

/// The real function `name` behind `door`; null if there is none or it is one of GLuRay's.
void* realFunction(Door door, Api api, const char* name);

template <class Function>
Function realFunction(Door door, Api api, const char* name) {
  return reinterpret_cast<Function>(realFunction(door, api, name));
}

/// The real OpenGL for contexts of this API, loaded by the first call. Prefers the functions of a vendor
/// door: the functions of the preload door are libGL's entry points, which lead back into the vendor door.
const gl::RealGl& realGl(Api api);

/// True for the outermost of GLuRay's hooks on this thread's stack. If both doors are open, the preload
/// door's glXMakeCurrent calls libGLX's, which calls the vendor door's. Only the outermost hook acts; inner
/// ones forward.
class Outermost {
 public:
  Outermost() : first_(depth_++ == 0) {}
  ~Outermost() { --depth_; }
  Outermost(const Outermost&) = delete;
  Outermost& operator=(const Outermost&) = delete;
  explicit operator bool() const { return first_; }

 private:
  static thread_local int depth_;
  bool first_;
};

}  // namespace gluray::intercept
