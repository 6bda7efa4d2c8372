/* The other ways to a GLX context. Argument: new (glXCreateNewContext and glXCreateWindow), attribs
   (glXCreateContextAttribsARB), pbuffer (no window at all). */
#include "linked.h"

#include <string.h>

typedef struct Target {
  Display* display;
  GLXDrawable drawable;
} Target;

static void show(void* user) {
  const Target* target = (const Target*)user;
  glXSwapBuffers(target->display, target->drawable);
}

static GLXContext makeContext(const char* way, Display* display, GLXFBConfig config) {
  if (strcmp(way, "attribs") != 0) return glXCreateNewContext(display, config, GLX_RGBA_TYPE, NULL, True);
  static const int attributes[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 2, GLX_CONTEXT_MINOR_VERSION_ARB, 1, None};
  const PFNGLXCREATECONTEXTATTRIBSARBPROC create =
      (PFNGLXCREATECONTEXTATTRIBSARBPROC)glXGetProcAddress((const GLubyte*)"glXCreateContextAttribsARB");
  return create ? create(display, config, NULL, True, attributes) : NULL;
}

/* A configuration with eight bits a colour: the default order puts deeper ones first. */
static GLXFBConfig chooseConfig(Display* display, int offScreen) {
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        offScreen ? GLX_PBUFFER_BIT : GLX_WINDOW_BIT,
                        GLX_DOUBLEBUFFER,
                        True,
                        GLX_DEPTH_SIZE,
                        24,
                        GLX_X_RENDERABLE,
                        True,
                        None};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  for (int i = 0; i < count; ++i) {
    int red = 0;
    glXGetFBConfigAttrib(display, configs[i], GLX_RED_SIZE, &red);
    if (red == 8) return configs[i];
  }
  fprintf(stderr, "no framebuffer configuration\n");
  exit(1);
}

int main(int argc, char** argv) {
  const char* way = argc > 1 ? argv[1] : "new";
  const int offScreen = strcmp(way, "pbuffer") == 0;
  Display* display = openDisplay();
  GLXFBConfig config = chooseConfig(display, offScreen);
  const int size[] = {GLX_PBUFFER_WIDTH, kWindowSize, GLX_PBUFFER_HEIGHT, kWindowSize, None};
  XVisualInfo* visual = offScreen ? NULL : glXGetVisualFromFBConfig(display, config);
  Target target = {display, offScreen ? glXCreatePbuffer(display, config, size)
                                      : glXCreateWindow(display, config, makeWindow(display, visual), NULL)};
  GLXContext context = makeContext(way, display, config);
  if (!context || !glXMakeContextCurrent(display, target.drawable, target.drawable, context))
    return fprintf(stderr, "no context\n"), 1;
  const Gl gl = linkedGl();
  const int right = workload(&gl, show, &target);
  glXMakeContextCurrent(display, None, None, NULL);
  glXDestroyContext(display, context);
  if (offScreen)
    glXDestroyPbuffer(display, target.drawable);
  else
    glXDestroyWindow(display, target.drawable);
  XCloseDisplay(display);
  return !right;
}
