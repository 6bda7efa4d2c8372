// GLX hooks: contexts, current contexts, buffer swaps. Covers GLX 1.4 and the extensions that show images.
#include "base/timeline.h"
#include "gl/context/stub.h"
#include "intercept/contexts/contexts.h"
#include "intercept/control/shown_windows.h"
#include "intercept/frames/direct_swap.h"
#include "intercept/frames/frames.h"
#include "intercept/frames/idle_refinement.h"
#include "intercept/frames/later_swap.h"
#include "intercept/hooks/hook_table.h"
#include "intercept/hooks/hooks.h"
#include "intercept/window_systems/drawable_size.h"
#include "intercept/windows/glx_windows.h"
#include "intercept/windows/idle_window_of_context.h"
#include "intercept/windows/lag.h"

#include <GL/glx.h>
#include <GL/glxext.h>

namespace gluray::intercept {
namespace {

/// The real function of the same name and type as `FUNCTION`, behind door D.
#define REAL(D, TYPE, NAME) static const auto real = realFunction<TYPE>(D, Api::glx, NAME)

/// Runs `call`, which creates a context that shares with `share`.
template <class F>
GLXContext creating(GLXContext share, F&& call) {
  const Outermost outermost;
  const GLXContext context = call();
  if (outermost) contextCreated(Api::glx, context, share);
  return context;
}

/// Runs `call`, which makes `context` current.
template <class F>
Bool makingCurrent(Display* dpy, GLXDrawable draw, GLXDrawable read, GLXContext context, F&& call) {
  const Outermost outermost;
  if (!outermost || isCurrent(Api::glx, context, {draw, read})) return call();
  leaveCurrent();
  const Bool done = call();
  if (done)
    becameCurrent(
        Api::glx, context, {draw, read}, [dpy, draw] { return drawableSize(dpy, draw); },
        [dpy, draw] { return isMapped(dpy, windowOf(draw)); });
  else
    stayCurrent();
  return done;
}

/// Runs `call`, which shows the back buffer of `drawable`.
template <class F>
auto swapping(const Outermost& outermost, GLXDrawable drawable, F&& call) {
  struct AfterSwap {
    const Outermost& outermost;
    GLXDrawable drawable;
    ~AfterSwap() {
      if (outermost) swapped(drawable);
    }
  };
  if (outermost) intercept::swapping(drawable);
  const AfterSwap afterSwap{outermost, drawable};
  const timeline::Span span("swap");
  return call();
}

/// Surrounds a swap: until it ends, no older image is put into the window. Afterwards the frame may be
/// refined.
struct Shows {
  const Outermost& outermost;
  Display* display;
  GLXDrawable drawable;
  Shows(const Outermost& of, Display* dpy, GLXDrawable shown) : outermost(of), display(dpy), drawable(shown) {
    if (outermost) windowChanges(drawable);
  }
  ~Shows() {
    if (outermost) refineShown(display, drawable), noteShown(display, drawable);
  }
  Shows(const Shows&) = delete;
  Shows& operator=(const Shows&) = delete;
};

template <Door D>
struct Glx {
  static GLXContext createContext(Display* dpy, XVisualInfo* visual, GLXContext share, Bool direct) {
    REAL(D, decltype(&glXCreateContext), "glXCreateContext");
    return creating(share, [&] { return real(dpy, visual, share, direct); });
  }
  static GLXContext createNewContext(Display* dpy, GLXFBConfig config, int type, GLXContext share,
                                     Bool direct) {
    REAL(D, decltype(&glXCreateNewContext), "glXCreateNewContext");
    return creating(share, [&] { return real(dpy, config, type, share, direct); });
  }
  static GLXContext createContextAttribs(Display* dpy, GLXFBConfig config, GLXContext share, Bool direct,
                                         const int* attributes) {
    REAL(D, PFNGLXCREATECONTEXTATTRIBSARBPROC, "glXCreateContextAttribsARB");
    return creating(share, [&] { return real(dpy, config, share, direct, attributes); });
  }
  static GLXContext createContextWithConfig(Display* dpy, GLXFBConfigSGIX config, int type, GLXContext share,
                                            Bool direct) {
    REAL(D, PFNGLXCREATECONTEXTWITHCONFIGSGIXPROC, "glXCreateContextWithConfigSGIX");
    return creating(share, [&] { return real(dpy, config, type, share, direct); });
  }
  static GLXContext importContext(Display* dpy, GLXContextID id) {
    REAL(D, PFNGLXIMPORTCONTEXTEXTPROC, "glXImportContextEXT");
    return creating(nullptr, [&] { return real(dpy, id); });
  }
  static void destroyContext(Display* dpy, GLXContext context) {
    REAL(D, decltype(&glXDestroyContext), "glXDestroyContext");
    const Outermost outermost;
    real(dpy, context);
    if (outermost) contextDestroyed(Api::glx, context);
  }
  static void freeContext(Display* dpy, GLXContext context) {
    REAL(D, PFNGLXFREECONTEXTEXTPROC, "glXFreeContextEXT");
    const Outermost outermost;
    real(dpy, context);
    if (outermost) contextDestroyed(Api::glx, context);
  }
  static void copyContext(Display* dpy, GLXContext source, GLXContext target, unsigned long mask) {
    REAL(D, decltype(&glXCopyContext), "glXCopyContext");
    afterFlush([&] { real(dpy, source, target, mask); });
  }

  static Bool makeCurrent(Display* dpy, GLXDrawable drawable, GLXContext context) {
    REAL(D, decltype(&glXMakeCurrent), "glXMakeCurrent");
    return makingCurrent(dpy, drawable, drawable, context, [&] { return real(dpy, drawable, context); });
  }
  static Bool makeContextCurrent(Display* dpy, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    REAL(D, decltype(&glXMakeContextCurrent), "glXMakeContextCurrent");
    return makingCurrent(dpy, draw, read, context, [&] { return real(dpy, draw, read, context); });
  }
  static Bool makeCurrentRead(Display* dpy, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    REAL(D, PFNGLXMAKECURRENTREADSGIPROC, "glXMakeCurrentReadSGI");
    return makingCurrent(dpy, draw, read, context, [&] { return real(dpy, draw, read, context); });
  }

  static void swapBuffers(Display* dpy, GLXDrawable drawable) {
    REAL(D, decltype(&glXSwapBuffers), "glXSwapBuffers");
    const Outermost outermost;
    const Shows shows(outermost, dpy, drawable);
    if (outermost && (swapsLater(dpy, drawable, real) || shownDirectly(dpy, drawable, real)))
      return swapped(drawable);
    swapping(outermost, drawable, [&] { real(dpy, drawable); });
  }
  static int64_t swapBuffersMsc(Display* dpy, GLXDrawable drawable, int64_t target, int64_t divisor,
                                int64_t remainder) {
    REAL(D, PFNGLXSWAPBUFFERSMSCOMLPROC, "glXSwapBuffersMscOML");
    const Outermost outermost;
    const Shows shows(outermost, dpy, drawable);
    return swapping(outermost, drawable, [&] { return real(dpy, drawable, target, divisor, remainder); });
  }
  static Bool waitForSbc(Display* dpy, GLXDrawable drawable, int64_t target, int64_t* ust, int64_t* msc,
                         int64_t* sbc) {
    REAL(D, PFNGLXWAITFORSBCOMLPROC, "glXWaitForSbcOML");
    return afterFlush([&] { return real(dpy, drawable, target, ust, msc, sbc); });
  }
  static Bool getSyncValues(Display* dpy, GLXDrawable drawable, int64_t* ust, int64_t* msc, int64_t* sbc) {
    REAL(D, PFNGLXGETSYNCVALUESOMLPROC, "glXGetSyncValuesOML");
    return afterFlush([&] { return real(dpy, drawable, ust, msc, sbc); });
  }
  /// Programs that select swap events wait for them, so their frames cannot lag.
  static void selectEvent(Display* dpy, GLXDrawable drawable, unsigned long mask) {
    REAL(D, decltype(&glXSelectEvent), "glXSelectEvent");
    if (mask & GLX_BUFFER_SWAP_COMPLETE_INTEL_MASK) neverLag();
    afterFlush([&] { real(dpy, drawable, mask); });
  }
  static void copySubBuffer(Display* dpy, GLXDrawable drawable, int x, int y, int width, int height) {
    REAL(D, PFNGLXCOPYSUBBUFFERMESAPROC, "glXCopySubBufferMESA");
    windowChanges(drawable);
    afterFlush([&] { real(dpy, drawable, x, y, width, height); });
  }
  static void waitGl() {
    REAL(D, decltype(&glXWaitGL), "glXWaitGL");
    afterFlush([&] { real(); });
  }
  static void bindTexImage(Display* dpy, GLXDrawable drawable, int buffer, const int* attributes) {
    REAL(D, PFNGLXBINDTEXIMAGEEXTPROC, "glXBindTexImageEXT");
    afterFlush([&] { real(dpy, drawable, buffer, attributes); });
    textureImageBound();
  }
  /// Drivers compile the glyphs' lists internally, where no door sees the calls. So the shadow GL gives them
  /// lists of the real OpenGL, which the program's lists then call.
  static void useXFont(Font font, int first, int count, int listBase) {
    REAL(D, decltype(&glXUseXFont), "glXUseXFont");
    const Outermost outermost;
    gl::Context* context = outermost ? gl::t_thread.context : nullptr;
    if (!context || context->info().off) return real(font, first, count, listBase);
    const auto make = [&](int realBase) { real(font, first, count, realBase); };
    context->protect([&] { gl::useXFont(*context, first, count, listBase, make); });
  }

  static GLXWindow createWindow(Display* dpy, GLXFBConfig config, Window window, const int* attributes) {
    REAL(D, decltype(&glXCreateWindow), "glXCreateWindow");
    const Outermost outermost;
    const GLXWindow name = real(dpy, config, window, attributes);
    if (outermost && name) glxWindowMade(name, window);
    return name;
  }
  static void destroyWindow(Display* dpy, GLXWindow window) {
    REAL(D, decltype(&glXDestroyWindow), "glXDestroyWindow");
    const Outermost outermost;
    if (outermost) drawableGoing(window);
    real(dpy, window);
    if (outermost) glxWindowGone(window);
  }
  static void destroyPbuffer(Display* dpy, GLXPbuffer pbuffer) {
    REAL(D, decltype(&glXDestroyPbuffer), "glXDestroyPbuffer");
    const Outermost outermost;
    if (outermost) drawableGoing(pbuffer);
    real(dpy, pbuffer);
  }
  static void destroyPixmap(Display* dpy, GLXPixmap pixmap) {
    REAL(D, decltype(&glXDestroyPixmap), "glXDestroyPixmap");
    const Outermost outermost;
    if (outermost) drawableGoing(pixmap);
    real(dpy, pixmap);
  }
  static void destroyGlxPixmap(Display* dpy, GLXPixmap pixmap) {
    REAL(D, decltype(&glXDestroyGLXPixmap), "glXDestroyGLXPixmap");
    const Outermost outermost;
    if (outermost) drawableGoing(pixmap);
    real(dpy, pixmap);
  }

  static void* find(const char* name) {
#define HOOK(NAME, FUNCTION) \
  { NAME, reinterpret_cast<void*>(&FUNCTION) }
    static const Hook hooks[] = {
        HOOK("glXCreateContext", createContext),
        HOOK("glXCreateNewContext", createNewContext),
        HOOK("glXCreateContextAttribsARB", createContextAttribs),
        HOOK("glXCreateContextWithConfigSGIX", createContextWithConfig),
        HOOK("glXImportContextEXT", importContext),
        HOOK("glXDestroyContext", destroyContext),
        HOOK("glXFreeContextEXT", freeContext),
        HOOK("glXCopyContext", copyContext),
        HOOK("glXMakeCurrent", makeCurrent),
        HOOK("glXMakeContextCurrent", makeContextCurrent),
        HOOK("glXMakeCurrentReadSGI", makeCurrentRead),
        HOOK("glXSwapBuffers", swapBuffers),
        HOOK("glXSwapBuffersMscOML", swapBuffersMsc),
        HOOK("glXWaitForSbcOML", waitForSbc),
        HOOK("glXGetSyncValuesOML", getSyncValues),
        HOOK("glXSelectEvent", selectEvent),
        HOOK("glXCopySubBufferMESA", copySubBuffer),
        HOOK("glXWaitGL", waitGl),
        HOOK("glXBindTexImageEXT", bindTexImage),
        HOOK("glXUseXFont", useXFont),
        HOOK("glXCreateWindow", createWindow),
        HOOK("glXDestroyWindow", destroyWindow),
        HOOK("glXDestroyPbuffer", destroyPbuffer),
        HOOK("glXDestroyPixmap", destroyPixmap),
        HOOK("glXDestroyGLXPixmap", destroyGlxPixmap),
    };
#undef HOOK
    return findHook(hooks, name);
  }
};

}  // namespace

void* glxHook(Door door, const char* name) {
  return door == kPreload ? Glx<kPreload>::find(name) : Glx<kVendorGlx>::find(name);
}

#undef REAL

}  // namespace gluray::intercept
