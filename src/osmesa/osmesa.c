/* OSMesa's interface (OpenGL that draws into the program's memory) over EGL pbuffers. The memory holds the
   picture after glFinish, glFlush, OSMesaGetColorBuffer and when another context becomes current. Contexts
   belong to one thread at a time. */
#include "intercept/window_systems/osmesa_api.h"
#include "osmesa/display.h"
#include "osmesa/opengl_calls.h"
#include "osmesa/pixels.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORTED __attribute__((visibility("default")))

enum { kLargestSide = 16384, kMaxEglAttributes = 8 };

struct osmesa_context {
  EGLContext context;
  EGLConfig config;
  EGLSurface surface; /* EGL_NO_SURFACE: never current */
  GLint depthBits;
  GLenum type;
  Memory memory; /* width and height are the surface's */
  void* depths;  /* of the last OSMesaGetDepthBuffer */
};

/* Marks this library: behind a preloaded one, EGL's contexts are those that count (intercept/hooks/osmesa).
 */
EXPORTED const int OSMesaIsOverEgl = 1;

static __thread OSMesaContext t_current;

typedef struct Wishes {
  GLenum format;
  int depthBits, stencilBits, accumBits;
  int profile, major, minor; /* 0: any */
} Wishes;

/* Makes a context. Restores the API that the program has bound for EGL. */
static OSMesaContext create(const Wishes* wishes, OSMesaContext share) {
  const EGLDisplay display = osmesaDisplay();
  const GLenum type = wishes->format == OSMESA_RGB_565 ? GL_UNSIGNED_SHORT_5_6_5 : GL_UNSIGNED_BYTE;
  if (display == EGL_NO_DISPLAY || !osmesaCalls() || !osmesaCanHold(wishes->format, type)) return NULL;
  if (wishes->accumBits > 0) {
    fprintf(stderr, "gluray-osmesa: EGL has no accumulation buffers; ask for 0 bits\n");
    return NULL;
  }
  OSMesaContext made = calloc(1, sizeof *made);
  if (!made) return NULL;
  EGLint attributes[kMaxEglAttributes];
  int count = 0;
  if (wishes->major > 0) {
    attributes[count++] = EGL_CONTEXT_MAJOR_VERSION, attributes[count++] = wishes->major;
    attributes[count++] = EGL_CONTEXT_MINOR_VERSION, attributes[count++] = wishes->minor;
  }
  if (wishes->profile == OSMESA_CORE_PROFILE) {
    attributes[count++] = EGL_CONTEXT_OPENGL_PROFILE_MASK;
    attributes[count++] = EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;
  }
  attributes[count] = EGL_NONE;
  const EGLenum api = eglQueryAPI();
  eglBindAPI(EGL_OPENGL_API);
  if (osmesaConfig(display, wishes->depthBits, wishes->stencilBits, &made->config))
    made->context =
        eglCreateContext(display, made->config, share ? share->context : EGL_NO_CONTEXT, attributes);
  eglBindAPI(api);
  if (made->context == EGL_NO_CONTEXT) return free(made), NULL;
  made->surface = EGL_NO_SURFACE;
  made->depthBits = wishes->depthBits, made->type = type;
  made->memory.format = wishes->format, made->memory.yUp = 1;
  return made;
}

EXPORTED OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext share) {
  return OSMesaCreateContextExt(format, 24, 8, 0, share);
}

EXPORTED OSMesaContext OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits,
                                              GLint accumBits, OSMesaContext share) {
  const Wishes wishes = {format, depthBits, stencilBits, accumBits, 0, 0, 0};
  return create(&wishes, share);
}

EXPORTED OSMesaContext OSMesaCreateContextAttribs(const int* attributes, OSMesaContext share) {
  Wishes wishes = {OSMESA_RGBA, 0, 0, 0, OSMESA_COMPAT_PROFILE, 0, 0};
  for (const int* at = attributes; at && *at; at += 2) {
    switch (at[0]) {
      case OSMESA_FORMAT: wishes.format = (GLenum)at[1]; break;
      case OSMESA_DEPTH_BITS: wishes.depthBits = at[1]; break;
      case OSMESA_STENCIL_BITS: wishes.stencilBits = at[1]; break;
      case OSMESA_ACCUM_BITS: wishes.accumBits = at[1]; break;
      case OSMESA_PROFILE: wishes.profile = at[1]; break;
      case OSMESA_CONTEXT_MAJOR_VERSION: wishes.major = at[1]; break;
      case OSMESA_CONTEXT_MINOR_VERSION: wishes.minor = at[1]; break;
      default: return NULL;
    }
  }
  const int known = wishes.profile == OSMESA_CORE_PROFILE || wishes.profile == OSMESA_COMPAT_PROFILE;
  const int sane = wishes.depthBits >= 0 && wishes.stencilBits >= 0 && wishes.accumBits >= 0 &&
                   wishes.major >= 0 && wishes.minor >= 0;
  return known && sane ? create(&wishes, share) : NULL;
}

static void writeMemory(OSMesaContext context) {
  if (context && context->memory.pixels) osmesaCopyColors(&context->memory);
}

/* Makes the context, or none, current, without touching the program's memory. */
static int bind(OSMesaContext context, EGLSurface surface) {
  const EGLenum api = eglQueryAPI();
  eglBindAPI(EGL_OPENGL_API);
  const int done =
      eglMakeCurrent(osmesaDisplay(), surface, surface, context ? context->context : EGL_NO_CONTEXT);
  eglBindAPI(api);
  return done;
}

EXPORTED void OSMesaDestroyContext(OSMesaContext context) {
  if (!context) return;
  if (context == t_current) bind(t_current = NULL, EGL_NO_SURFACE);
  if (context->surface != EGL_NO_SURFACE) eglDestroySurface(osmesaDisplay(), context->surface);
  eglDestroyContext(osmesaDisplay(), context->context);
  free(context->depths);
  free(context);
}

/* The context's surface of this size, its own one or a new one. */
static EGLSurface surfaceFor(OSMesaContext context, GLsizei width, GLsizei height) {
  const Memory* const memory = &context->memory;
  if (context->surface != EGL_NO_SURFACE && memory->width == width && memory->height == height)
    return context->surface;
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  return eglCreatePbufferSurface(osmesaDisplay(), context->config, size);
}

EXPORTED GLboolean OSMesaMakeCurrent(OSMesaContext context, void* buffer, GLenum type, GLsizei width,
                                     GLsizei height) {
  if (!context && !buffer) {
    writeMemory(t_current);
    return bind(t_current = NULL, EGL_NO_SURFACE) ? GL_TRUE : GL_FALSE;
  }
  if (!context || !buffer || width < 1 || height < 1 || width > kLargestSide || height > kLargestSide ||
      !osmesaCanHold(context->memory.format, type))
    return GL_FALSE;
  const EGLSurface surface = surfaceFor(context, width, height);
  if (surface == EGL_NO_SURFACE) return GL_FALSE;
  writeMemory(t_current);
  if (!bind(context, surface)) {
    if (surface != context->surface) eglDestroySurface(osmesaDisplay(), surface);
    return GL_FALSE;
  }
  if (surface != context->surface && context->surface != EGL_NO_SURFACE)
    eglDestroySurface(osmesaDisplay(), context->surface);
  context->surface = surface;
  context->memory.pixels = buffer, context->memory.width = width, context->memory.height = height;
  t_current = context;
  return GL_TRUE;
}

EXPORTED OSMesaContext OSMesaGetCurrentContext(void) { return t_current; }

EXPORTED void OSMesaPixelStore(GLint name, GLint value) {
  if (!t_current) return;
  if (name == OSMESA_ROW_LENGTH && value >= 0) t_current->memory.rowLength = value;
  if (name == OSMESA_Y_UP) t_current->memory.yUp = value != 0;
}

EXPORTED void OSMesaGetIntegerv(GLint name, GLint* value) {
  const OSMesaContext c = t_current;
  switch (name) {
    case OSMESA_WIDTH: *value = c ? c->memory.width : 0; break;
    case OSMESA_HEIGHT: *value = c ? c->memory.height : 0; break;
    case OSMESA_FORMAT: *value = c ? (GLint)c->memory.format : 0; break;
    case OSMESA_TYPE: *value = c ? (GLint)c->type : 0; break;
    case OSMESA_ROW_LENGTH: *value = c ? c->memory.rowLength : 0; break;
    case OSMESA_Y_UP: *value = c ? c->memory.yUp : 0; break;
    case OSMESA_MAX_WIDTH:
    case OSMESA_MAX_HEIGHT: *value = kLargestSide; break;
    default: break;
  }
}

EXPORTED GLboolean OSMesaGetColorBuffer(OSMesaContext context, GLint* width, GLint* height, GLint* format,
                                        void** buffer) {
  const int has = context && context->memory.pixels;
  if (has && context == t_current) writeMemory(context);
  *width = has ? context->memory.width : 0, *height = has ? context->memory.height : 0;
  *format = has ? (GLint)context->memory.format : 0, *buffer = has ? context->memory.pixels : NULL;
  return has ? GL_TRUE : GL_FALSE;
}

/* Depths lie in memory of the context until the next call, row by row, the first row as OSMESA_Y_UP says. */
EXPORTED GLboolean OSMesaGetDepthBuffer(OSMesaContext context, GLint* width, GLint* height,
                                        GLint* bytesPerValue, void** buffer) {
  *width = *height = *bytesPerValue = 0, *buffer = NULL;
  if (!context || context->surface == EGL_NO_SURFACE || context->depthBits <= 0) return GL_FALSE;
  const OSMesaContext before = t_current;
  if (context != before && !bind(context, context->surface)) return GL_FALSE;
  const int bytes = context->depthBits <= 16 ? 2 : 4;
  Memory depths = context->memory;
  depths.rowLength = 0;
  void* const room = realloc(context->depths, (size_t)depths.width * (size_t)depths.height * (size_t)bytes);
  if (room) context->depths = depths.pixels = room;
  const int done = room && osmesaCopyDepths(&depths, bytes);
  if (context != before) bind(before, before ? before->surface : EGL_NO_SURFACE);
  if (!done) return GL_FALSE;
  *width = depths.width, *height = depths.height, *bytesPerValue = bytes, *buffer = room;
  return GL_TRUE;
}

EXPORTED void OSMesaColorClamp(GLboolean enable) {
  if (t_current) osmesaCalls()->ClampColor(GL_CLAMP_FRAGMENT_COLOR, enable ? GL_TRUE : GL_FIXED_ONLY);
}

/* Mesa's filters for finished images are not offered: this has no effect. */
EXPORTED void OSMesaPostprocess(OSMesaContext context, const char* filter, unsigned enableValue) {
  (void)context, (void)filter, (void)enableValue;
}

EXPORTED void glFinish(void) {
  const Calls* const gl = osmesaCalls();
  if (!gl) return;
  gl->Finish();
  writeMemory(t_current);
}

EXPORTED void glFlush(void) {
  const Calls* const gl = osmesaCalls();
  if (!gl) return;
  gl->Flush();
  writeMemory(t_current);
}

EXPORTED OSMESAproc OSMesaGetProcAddress(const char* name) {
  static const struct {
    const char* name;
    OSMESAproc call;
  } kOurs[] = {
#define OURS(NAME) {#NAME, (OSMESAproc)NAME}
      OURS(OSMesaCreateContext),
      OURS(OSMesaCreateContextExt),
      OURS(OSMesaCreateContextAttribs),
      OURS(OSMesaDestroyContext),
      OURS(OSMesaMakeCurrent),
      OURS(OSMesaGetCurrentContext),
      OURS(OSMesaPixelStore),
      OURS(OSMesaGetIntegerv),
      OURS(OSMesaGetDepthBuffer),
      OURS(OSMesaGetColorBuffer),
      OURS(OSMesaColorClamp),
      OURS(OSMesaPostprocess),
      OURS(OSMesaGetProcAddress),
      OURS(glFinish),
      OURS(glFlush),
#undef OURS
  };
  for (size_t i = 0; i < sizeof kOurs / sizeof *kOurs; ++i)
    if (strcmp(name, kOurs[i].name) == 0) return kOurs[i].call;
  return strncmp(name, "OSMesa", 6) == 0 ? NULL : eglGetProcAddress(name);
}
