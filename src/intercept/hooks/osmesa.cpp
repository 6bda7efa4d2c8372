// OSMesa: off-screen contexts that draw into the program's memory. Only the preload door supports them.
#include "intercept/contexts/contexts.h"
#include "intercept/hooks/hook_table.h"
#include "intercept/hooks/hooks.h"
#include "intercept/window_systems/osmesa_api.h"

namespace gluray::intercept {
namespace {

#define REAL(TYPE, NAME) static const auto real = realFunction<TYPE>(kPreload, Api::osmesa, NAME)

/// Whether libOSMesa is GLuRay's own (src/osmesa), whose contexts are EGL's: the hooks of EGL see them.
bool isOverEgl() {
  static const bool is = realFunction<const int*>(kPreload, Api::osmesa, "OSMesaIsOverEgl") != nullptr;
  return is;
}

OSMesaContext createContext(GLenum format, OSMesaContext share) {
  REAL(decltype(&OSMesaCreateContext), "OSMesaCreateContext");
  const OSMesaContext context = real(format, share);
  if (!isOverEgl()) contextCreated(Api::osmesa, context, share);
  return context;
}

OSMesaContext createContextExt(GLenum format, GLint depthBits, GLint stencilBits, GLint accumBits,
                               OSMesaContext share) {
  REAL(decltype(&OSMesaCreateContextExt), "OSMesaCreateContextExt");
  const OSMesaContext context = real(format, depthBits, stencilBits, accumBits, share);
  if (!isOverEgl()) contextCreated(Api::osmesa, context, share);
  return context;
}

OSMesaContext createContextAttribs(const int* attributes, OSMesaContext share) {
  REAL(decltype(&OSMesaCreateContextAttribs), "OSMesaCreateContextAttribs");
  const OSMesaContext context = real(attributes, share);
  if (!isOverEgl()) contextCreated(Api::osmesa, context, share);
  return context;
}

/// Destroying the current context leaves no context current.
void destroyContext(OSMesaContext context) {
  REAL(decltype(&OSMesaDestroyContext), "OSMesaDestroyContext");
  if (isOverEgl()) return real(context);
  static const auto currentContext =
      realFunction<decltype(&OSMesaGetCurrentContext)>(kPreload, Api::osmesa, "OSMesaGetCurrentContext");
  const bool current = context && currentContext && currentContext() == context;
  if (current) leaveCurrent();
  real(context);
  if (current) becameCurrent(Api::osmesa, nullptr, {});
  contextDestroyed(Api::osmesa, context);
}

/// The buffer acts as the drawable: an image is complete when the program changes the buffer or the context.
GLboolean makeCurrent(OSMesaContext context, void* buffer, GLenum type, GLsizei width, GLsizei height) {
  REAL(decltype(&OSMesaMakeCurrent), "OSMesaMakeCurrent");
  if (isOverEgl()) return real(context, buffer, type, width, height);
  leaveCurrent();
  const GLboolean done = real(context, buffer, type, width, height);
  if (done)
    becameCurrent(Api::osmesa, context, {reinterpret_cast<uintptr_t>(buffer), 0},
                  [width, height] { return glm::ivec2(width, height); });
  else
    stayCurrent();
  return done;
}

GLboolean getDepthBuffer(OSMesaContext context, GLint* width, GLint* height, GLint* bytesPerValue,
                         void** buffer) {
  REAL(decltype(&OSMesaGetDepthBuffer), "OSMesaGetDepthBuffer");
  flushCurrent();
  return real(context, width, height, bytesPerValue, buffer);
}

GLboolean getColorBuffer(OSMesaContext context, GLint* width, GLint* height, GLint* format, void** buffer) {
  REAL(decltype(&OSMesaGetColorBuffer), "OSMesaGetColorBuffer");
  flushCurrent();
  return real(context, width, height, format, buffer);
}

}  // namespace

void* osmesaHook(const char* name) {
#define HOOK(NAME, FUNCTION) \
  { NAME, reinterpret_cast<void*>(&FUNCTION) }
  static const Hook hooks[] = {
      HOOK("OSMesaCreateContext", createContext),
      HOOK("OSMesaCreateContextExt", createContextExt),
      HOOK("OSMesaCreateContextAttribs", createContextAttribs),
      HOOK("OSMesaDestroyContext", destroyContext),
      HOOK("OSMesaMakeCurrent", makeCurrent),
      HOOK("OSMesaGetDepthBuffer", getDepthBuffer),
      HOOK("OSMesaGetColorBuffer", getColorBuffer),
  };
#undef HOOK
  return findHook(hooks, name);
}

#undef REAL

}  // namespace gluray::intercept
