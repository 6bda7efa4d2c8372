// EGL hooks for desktop OpenGL: contexts, current contexts, buffer swaps, fences. Covers EGL 1.5 and the
// extensions that show images and create fences.
#include "base/timeline.h"
#include "intercept/contexts/contexts.h"
#include "intercept/control/shown_windows.h"
#include "intercept/frames/frames.h"
#include "intercept/frames/idle_refinement.h"
#include "intercept/hooks/hook_table.h"
#include "intercept/hooks/hooks.h"
#include "intercept/windows/idle_window_of_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdint>
#include <cstring>

namespace gluray::intercept {
namespace {

/// The real function of the same name and type, behind door D.
#define REAL(D, TYPE, NAME) static const auto real = realFunction<TYPE>(D, Api::egl, NAME)

uintptr_t drawableOf(EGLSurface surface) { return reinterpret_cast<uintptr_t>(surface); }

/// Queries the size of `surface` behind door D; empty for contexts without a surface.
template <Door D>
AskSize sizeOf(EGLDisplay display, EGLSurface surface) {
  if (surface == EGL_NO_SURFACE) return {};
  return [display, surface] {
    REAL(D, decltype(&eglQuerySurface), "eglQuerySurface");
    EGLint width = 0, height = 0;
    const bool known =
        real && real(display, surface, EGL_WIDTH, &width) && real(display, surface, EGL_HEIGHT, &height);
    return known ? glm::ivec2(width, height) : glm::ivec2(0);
  };
}

/// Queries whether `surface` is a window: only pbuffers have a largest size (EGL 1.5, 3.5.6).
template <Door D>
AskShown isWindow(EGLDisplay display, EGLSurface surface) {
  if (surface == EGL_NO_SURFACE) return {};
  return [display, surface] {
    REAL(D, decltype(&eglQuerySurface), "eglQuerySurface");
    EGLint largest = -1;
    return real && real(display, surface, EGL_LARGEST_PBUFFER, &largest) && largest == -1;
  };
}

/// Runs `call`, which shows the back buffer of `surface`.
template <class F>
EGLBoolean swapping(EGLSurface surface, F&& call) {
  const Outermost outermost;
  if (outermost) intercept::swapping(drawableOf(surface));
  const EGLBoolean done = [&] {
    const timeline::Span span("swap");
    return call();
  }();
  if (outermost)
    swapped(drawableOf(surface)), refineShown(nullptr, drawableOf(surface)), noteShownSurface(surface);
  return done;
}

/// The id of the X window that a native window points to: a number of 32 bits (XCB), or of 64 bits (Xlib)
/// with the lower half first. On other platforms, a number that is not a window of the X server.
uint32_t nameAt(const void* window) {
  uint32_t name = 0;
  std::memcpy(&name, window, sizeof name);
  return name;
}

template <Door D>
struct Egl {
  static EGLContext createContext(EGLDisplay display, EGLConfig config, EGLContext share,
                                  const EGLint* attributes) {
    REAL(D, decltype(&eglCreateContext), "eglCreateContext");
    const Outermost outermost;
    const EGLContext context = real(display, config, share, attributes);
    if (outermost) contextCreated(Api::egl, context, share, display);
    return context;
  }
  static EGLBoolean destroyContext(EGLDisplay display, EGLContext context) {
    REAL(D, decltype(&eglDestroyContext), "eglDestroyContext");
    const Outermost outermost;
    const EGLBoolean done = real(display, context);
    if (outermost && done) contextDestroyed(Api::egl, context);
    return done;
  }
  static EGLBoolean makeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
    REAL(D, decltype(&eglMakeCurrent), "eglMakeCurrent");
    const Outermost outermost;
    const Drawables drawables{drawableOf(draw), drawableOf(read)};
    if (!outermost || isCurrent(Api::egl, context, drawables)) return real(display, draw, read, context);
    leaveCurrent();
    const EGLBoolean done = real(display, draw, read, context);
    if (done)
      becameCurrent(Api::egl, context, drawables, sizeOf<D>(display, draw), isWindow<D>(display, draw));
    else
      stayCurrent();
    return done;
  }
  static EGLBoolean releaseThread() {
    REAL(D, decltype(&eglReleaseThread), "eglReleaseThread");
    const Outermost outermost;
    if (!outermost) return real();
    leaveCurrent();
    const EGLBoolean done = real();
    if (done)
      becameCurrent(Api::egl, nullptr, {});
    else
      stayCurrent();
    return done;
  }
  static EGLBoolean terminate(EGLDisplay display) {
    REAL(D, decltype(&eglTerminate), "eglTerminate");
    const Outermost outermost;
    if (outermost) flushCurrent();
    const EGLBoolean done = real(display);
    if (outermost && done) displayTerminated(display);
    return done;
  }

  static EGLBoolean swapBuffers(EGLDisplay display, EGLSurface surface) {
    REAL(D, decltype(&eglSwapBuffers), "eglSwapBuffers");
    return swapping(surface, [&] { return real(display, surface); });
  }
  static EGLBoolean swapWithDamageKhr(EGLDisplay display, EGLSurface surface, const EGLint* rectangles,
                                      EGLint count) {
    REAL(D, PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC, "eglSwapBuffersWithDamageKHR");
    return swapping(surface, [&] { return real(display, surface, rectangles, count); });
  }
  static EGLBoolean swapWithDamageExt(EGLDisplay display, EGLSurface surface, const EGLint* rectangles,
                                      EGLint count) {
    REAL(D, PFNEGLSWAPBUFFERSWITHDAMAGEEXTPROC, "eglSwapBuffersWithDamageEXT");
    return swapping(surface, [&] { return real(display, surface, rectangles, count); });
  }
  static EGLBoolean postSubBuffer(EGLDisplay display, EGLSurface surface, EGLint x, EGLint y, EGLint width,
                                  EGLint height) {
    REAL(D, PFNEGLPOSTSUBBUFFERNVPROC, "eglPostSubBufferNV");
    return afterFlush([&] { return real(display, surface, x, y, width, height); });
  }
  static EGLBoolean copyBuffers(EGLDisplay display, EGLSurface surface, EGLNativePixmapType target) {
    REAL(D, decltype(&eglCopyBuffers), "eglCopyBuffers");
    return afterFlush([&] { return real(display, surface, target); });
  }
  static EGLBoolean waitGl() {
    REAL(D, decltype(&eglWaitGL), "eglWaitGL");
    return afterFlush([&] { return real(); });
  }
  static EGLBoolean waitClient() {
    REAL(D, decltype(&eglWaitClient), "eglWaitClient");
    return afterFlush([&] { return real(); });
  }
  /// Other APIs and processes may also wait for the fence.
  static EGLSync createSync(EGLDisplay display, EGLenum type, const EGLAttrib* attributes) {
    REAL(D, decltype(&eglCreateSync), "eglCreateSync");
    return afterFlush([&] { return real(display, type, attributes); });
  }
  static EGLSyncKHR createSyncKhr(EGLDisplay display, EGLenum type, const EGLint* attributes) {
    REAL(D, PFNEGLCREATESYNCKHRPROC, "eglCreateSyncKHR");
    return afterFlush([&] { return real(display, type, attributes); });
  }
  static EGLBoolean bindTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
    REAL(D, decltype(&eglBindTexImage), "eglBindTexImage");
    const EGLBoolean done = afterFlush([&] { return real(display, surface, buffer); });
    textureImageBound();
    return done;
  }
  static EGLSurface createWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
                                        const EGLint* attributes) {
    REAL(D, decltype(&eglCreateWindowSurface), "eglCreateWindowSurface");
    const Outermost outermost;
    const EGLSurface surface = real(display, config, window, attributes);
    if (outermost) noteSurface(surface, (uint64_t)window);  // a number or a pointer
    return surface;
  }
  static EGLSurface createPlatformWindow(EGLDisplay display, EGLConfig config, void* window,
                                         const EGLAttrib* attributes) {
    REAL(D, decltype(&eglCreatePlatformWindowSurface), "eglCreatePlatformWindowSurface");
    const Outermost outermost;
    const EGLSurface surface = real(display, config, window, attributes);
    if (outermost && surface) noteSurface(surface, nameAt(window));
    return surface;
  }
  static EGLSurface createPlatformWindowExt(EGLDisplay display, EGLConfig config, void* window,
                                            const EGLint* attributes) {
    REAL(D, PFNEGLCREATEPLATFORMWINDOWSURFACEEXTPROC, "eglCreatePlatformWindowSurfaceEXT");
    const Outermost outermost;
    const EGLSurface surface = real(display, config, window, attributes);
    if (outermost && surface) noteSurface(surface, nameAt(window));
    return surface;
  }
  static EGLBoolean destroySurface(EGLDisplay display, EGLSurface surface) {
    REAL(D, decltype(&eglDestroySurface), "eglDestroySurface");
    const Outermost outermost;
    if (outermost) drawableGoing(drawableOf(surface)), forgetSurface(surface);
    return real(display, surface);
  }

  static void* find(const char* name) {
#define HOOK(NAME, FUNCTION) \
  { NAME, reinterpret_cast<void*>(&FUNCTION) }
    static const Hook hooks[] = {
        HOOK("eglCreateContext", createContext),
        HOOK("eglDestroyContext", destroyContext),
        HOOK("eglMakeCurrent", makeCurrent),
        HOOK("eglReleaseThread", releaseThread),
        HOOK("eglTerminate", terminate),
        HOOK("eglSwapBuffers", swapBuffers),
        HOOK("eglSwapBuffersWithDamageKHR", swapWithDamageKhr),
        HOOK("eglSwapBuffersWithDamageEXT", swapWithDamageExt),
        HOOK("eglPostSubBufferNV", postSubBuffer),
        HOOK("eglCopyBuffers", copyBuffers),
        HOOK("eglWaitGL", waitGl),
        HOOK("eglWaitClient", waitClient),
        HOOK("eglCreateSync", createSync),
        HOOK("eglCreateSyncKHR", createSyncKhr),
        HOOK("eglBindTexImage", bindTexImage),
        HOOK("eglCreateWindowSurface", createWindowSurface),
        HOOK("eglCreatePlatformWindowSurface", createPlatformWindow),
        HOOK("eglCreatePlatformWindowSurfaceEXT", createPlatformWindowExt),
        HOOK("eglDestroySurface", destroySurface),
    };
#undef HOOK
    return findHook(hooks, name);
  }
};

}  // namespace

void* eglHook(Door door, const char* name) {
  return door == kPreload ? Egl<kPreload>::find(name) : Egl<kVendorEgl>::find(name);
}

#undef REAL

}  // namespace gluray::intercept
