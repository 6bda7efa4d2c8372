/* Loads OpenGL as VTK 9.4 does: nothing is linked; the libraries of GLX, EGL and OSMesa are opened in turn
   until one gives a context, and glad fetches every function. Argument: auto, or the one to be used: glx,
   egl, osmesa. Then draws a mesh as VTK's polydata mapper does and writes the images to standard output. */
#define GL_GLEXT_PROTOTYPES /* before the first gl.h, for polydata.h */
#include "intercept/window_systems/osmesa_api.h"
#include "polydata.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glx.h>
#include <GL/glxext.h>
#include <dlfcn.h>
#include <string.h>

static void* library;
static void* (*getProcAddress)(const char*);

/* glad: uses the library's own lookup, then dlsym. */
static void* lookup(const char* name) {
  void* found = getProcAddress ? getProcAddress(name) : NULL;
  return found ? found : dlsym(library, name);
}

static int openLibrary(const char* const* names, const char* lookupName) {
  for (library = NULL; *names && !library; ++names) library = dlopen(*names, RTLD_LAZY | RTLD_LOCAL);
  if (!library) return 0;
  getProcAddress = (void* (*)(const char*))dlsym(library, lookupName);
  return getProcAddress != NULL;
}

static int giveUp(const char* what) {
  fprintf(stderr, "%s\n", what);
  if (library) dlclose(library);
  return 0;
}

/* glad looks every name up again, by the name of its own variable: a plain function here. */
#define FIND(name) const __typeof__(&name) find_##name = (__typeof__(&name))lookup(#name)

static int openGlx(void) {
  static const char* const names[] = {"libGL.so.1", "libGL.so", NULL};
  if (!openLibrary(names, "glXGetProcAddressARB")) return giveUp("no libGL");
  Display* display = XOpenDisplay(NULL);
  if (!display) return giveUp("no display");
  FIND(glXChooseFBConfig);
  FIND(glXGetVisualFromFBConfig);
  FIND(glXMakeCurrent);
  const PFNGLXCREATECONTEXTATTRIBSARBPROC create =
      (PFNGLXCREATECONTEXTATTRIBSARBPROC)lookup("glXCreateContextAttribsARB");
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_WINDOW_BIT,
                        GLX_RENDER_TYPE,
                        GLX_RGBA_BIT,
                        GLX_RED_SIZE,
                        1,
                        GLX_DEPTH_SIZE,
                        1,
                        GLX_DOUBLEBUFFER,
                        True,
                        None};
  int count = 0;
  GLXFBConfig* configs = find_glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (!configs || !count || !create) return giveUp("no configuration for GLX");
  const int version[] = {
      GLX_CONTEXT_MAJOR_VERSION_ARB,    3,   GLX_CONTEXT_MINOR_VERSION_ARB, 2, GLX_CONTEXT_PROFILE_MASK_ARB,
      GLX_CONTEXT_CORE_PROFILE_BIT_ARB, None};
  const GLXContext context = create(display, configs[0], NULL, True, version);
  XVisualInfo* visual = find_glXGetVisualFromFBConfig(display, configs[0]);
  if (!context || !visual) return giveUp("no context of GLX");
  XSetWindowAttributes attributes = {0};
  attributes.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
  const Window window =
      XCreateWindow(display, DefaultRootWindow(display), 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput,
                    visual->visual, CWBorderPixel | CWColormap, &attributes);
  return find_glXMakeCurrent(display, window, context) || giveUp("no current context of GLX");
}

static int openEgl(void) {
  static const char* const names[] = {"libEGL.so.1", "libEGL.so", NULL};
  if (!openLibrary(names, "eglGetProcAddress")) return giveUp("no libEGL");
  FIND(eglInitialize);
  FIND(eglBindAPI);
  FIND(eglChooseConfig);
  FIND(eglCreateContext);
  FIND(eglMakeCurrent);
  const PFNEGLGETPLATFORMDISPLAYEXTPROC getDisplay =
      (PFNEGLGETPLATFORMDISPLAYEXTPROC)lookup("eglGetPlatformDisplayEXT");
  const EGLDisplay display =
      getDisplay ? getDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL) : EGL_NO_DISPLAY;
  if (!display || !find_eglInitialize(display, NULL, NULL) || !find_eglBindAPI(EGL_OPENGL_API))
    return giveUp("no EGL");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            2,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!find_eglChooseConfig(display, wanted, &config, 1, &count) || !count)
    return giveUp("no configuration for EGL");
  const EGLContext context = find_eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (!context) return giveUp("no context of EGL");
  return find_eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE ||
         giveUp("no current context of EGL");
}

static int openOsmesa(void) {
  static const char* const names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", NULL};
  static unsigned char pixels[kHeight * kWidth * 4];
  if (!openLibrary(names, "OSMesaGetProcAddress")) return giveUp("no libOSMesa");
  FIND(OSMesaCreateContextAttribs);
  FIND(OSMesaMakeCurrent);
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_DEPTH_BITS,
                        24,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        2,
                        0};
  const OSMesaContext context = find_OSMesaCreateContextAttribs(wanted, NULL);
  if (!context) return giveUp("no context of OSMesa");
  return find_OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight) ||
         giveUp("no current context of OSMesa");
}

int main(int argc, char** argv) {
  const char* way = argc > 1 ? argv[1] : "auto";
  const int any = strcmp(way, "auto") == 0;
  const int open = ((any || strcmp(way, "glx") == 0) && openGlx()) ||
                   ((any || strcmp(way, "egl") == 0) && openEgl()) ||
                   ((any || strcmp(way, "osmesa") == 0) && openOsmesa());
  if (!open) return fprintf(stderr, "no way to OpenGL\n"), 1;
  Functions gl;
  if (!loadFunctions(&gl, lookup)) return 1;
  fprintf(stderr, "%s\n", (const char*)gl.GetString(GL_VERSION));
  return !drawPolydata(&gl);
}
