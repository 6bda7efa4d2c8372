#include "doctor/probe_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glx.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace gluray::launcher {
namespace {

constexpr int kSize = 64, kFrames = 2;

/// A library opened by dlopen: the launcher does not link OpenGL.
class Library {
 public:
  explicit Library(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) throw std::runtime_error(dlerror());
  }
  template <class F>
  F find(const char* name) const {
    return reinterpret_cast<F>(dlsym(handle_, name));
  }

 private:
  void* handle_;
};

#define FIND(library, name) const auto name##_ = (library).find<decltype(&name)>(#name)

void require(bool there, const char* what) {
  if (!there) throw std::runtime_error(std::string("no ") + what);
}

template <class Find>
void draw(const Find& find) {
  const auto clear = reinterpret_cast<decltype(&glClear)>(find("glClear"));
  const auto enable = reinterpret_cast<decltype(&glEnable)>(find("glEnable"));
  const auto begin = reinterpret_cast<decltype(&glBegin)>(find("glBegin"));
  const auto vertex = reinterpret_cast<decltype(&glVertex3f)>(find("glVertex3f"));
  const auto end = reinterpret_cast<decltype(&glEnd)>(find("glEnd"));
  require(clear && enable && begin && vertex && end, "fixed function");
  clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  enable(GL_DEPTH_TEST);
  begin(GL_TRIANGLES);
  vertex(-0.5f, -0.5f, 0.0f), vertex(0.5f, -0.5f, 0.1f), vertex(0.0f, 0.5f, 0.2f);
  end();
}

template <class Find>
void tell(const Find& find) {
  const auto getString = reinterpret_cast<decltype(&glGetString)>(find("glGetString"));
  require(getString, "glGetString");
  for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
    const auto* text = reinterpret_cast<const char*>(getString(name));
    std::printf("%s\n", text ? text : "");
  }
  std::fflush(stdout);
}

void probeGlx() {
  const Library x11("libX11.so.6"), gl("libGL.so.1");
  FIND(x11, XOpenDisplay);
  FIND(x11, XCreateColormap);
  FIND(x11, XCreateWindow);
  FIND(x11, XRootWindow);
  FIND(x11, XDefaultScreen);
  FIND(gl, glXChooseVisual);
  FIND(gl, glXCreateContext);
  FIND(gl, glXMakeCurrent);
  FIND(gl, glXSwapBuffers);
  FIND(gl, glXDestroyContext);
  require(glXChooseVisual_ && glXCreateContext_ && glXMakeCurrent_ && glXSwapBuffers_ && glXDestroyContext_,
          "GLX");
  Display* display = XOpenDisplay_(nullptr);
  require(display, "connection to the X display");
  const int screen = XDefaultScreen_(display);
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 16, None};
  XVisualInfo* visual = glXChooseVisual_(display, screen, wanted);
  require(visual, "GLX visual with colour, depth and two buffers");
  const Window root = XRootWindow_(display, screen);
  XSetWindowAttributes attributes{};
  attributes.colormap = XCreateColormap_(display, root, visual->visual, AllocNone);
  const Window window = XCreateWindow_(display, root, 0, 0, kSize, kSize, 0, visual->depth, InputOutput,
                                       visual->visual, CWColormap, &attributes);
  const GLXContext context = glXCreateContext_(display, visual, nullptr, True);
  require(context && glXMakeCurrent_(display, window, context), "GLX context");
  const auto find = [&](const char* name) { return gl.find<void*>(name); };
  tell(find);
  for (int i = 0; i < kFrames; ++i) {
    draw(find);
    glXSwapBuffers_(display, window);
  }
  glXMakeCurrent_(display, None, nullptr);
  glXDestroyContext_(display, context);
}

void probeEgl() {
  const Library egl("libEGL.so.1");
  FIND(egl, eglGetProcAddress);
  FIND(egl, eglInitialize);
  FIND(egl, eglBindAPI);
  FIND(egl, eglChooseConfig);
  FIND(egl, eglGetConfigAttrib);
  FIND(egl, eglCreatePbufferSurface);
  FIND(egl, eglCreateContext);
  FIND(egl, eglMakeCurrent);
  FIND(egl, eglSwapBuffers);
  const auto find = [&](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress_(name)); };
  const auto platformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(find("eglGetPlatformDisplayEXT"));
  require(platformDisplay, "EGL platforms");
  const EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  require(display != EGL_NO_DISPLAY && eglInitialize_(display, nullptr, nullptr),
          "EGL display without a screen");
  require(eglBindAPI_(EGL_OPENGL_API), "OpenGL through EGL");
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_NONE};
  EGLConfig configs[64];
  EGLint count = 0, bits = 0;
  require(eglChooseConfig_(display, wanted, configs, 64, &count) && count > 0,
          "EGL configuration for OpenGL");
  // eglChooseConfig sorts deeper colours first; takes the first with 8 bits of red.
  const EGLConfig* last = configs + count;
  const EGLConfig* found =
      std::find_if(static_cast<const EGLConfig*>(configs), last, [&](EGLConfig candidate) {
        return eglGetConfigAttrib_(display, candidate, EGL_RED_SIZE, &bits) && bits == 8;
      });
  const EGLConfig config = found == last ? configs[0] : *found;
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface_(display, config, size);
  const EGLContext context = eglCreateContext_(display, config, EGL_NO_CONTEXT, nullptr);
  require(context != EGL_NO_CONTEXT && eglMakeCurrent_(display, surface, surface, context), "EGL context");
  tell(find);
  for (int i = 0; i < kFrames; ++i) {
    draw(find);
    eglSwapBuffers_(display, surface);
  }
  eglMakeCurrent_(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace

int probeContext(const std::string& api) {
  try {
    if (api == "glx")
      probeGlx();
    else
      probeEgl();
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}

}  // namespace gluray::launcher
