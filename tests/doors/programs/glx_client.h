/* GLX for door tests: functions as a table, so that the same client runs on linked, dlsym'ed and looked-up
 * functions. */
#pragma once
#include "x_window.h"

#include <GL/glx.h>
#include <GL/glxext.h>

// clang-format off: its layout of such lists never settles
#define GLX_FUNCTIONS(X)   \
  X(ChooseVisual)          \
  X(ChooseFBConfig)        \
  X(GetVisualFromFBConfig) \
  X(CreateContext)         \
  X(CreateNewContext)      \
  X(DestroyContext)        \
  X(MakeCurrent)           \
  X(MakeContextCurrent)    \
  X(SwapBuffers)           \
  X(CreatePbuffer)         \
  X(DestroyPbuffer)        \
  X(CreateWindow)          \
  X(DestroyWindow)
// clang-format on

/* &* : names may be functions or, with some loaders, pointers to functions. */
typedef struct Glx {
#define X(name) __typeof__(&*glX##name) name;
  GLX_FUNCTIONS(X)
#undef X
} Glx;

static inline int loadGlx(Glx* glx, GlLookup lookup) {
#define X(name)                                                    \
  if (!(glx->name = (__typeof__(&*glX##name))lookup("glX" #name))) \
    return fprintf(stderr, "no glX" #name "\n"), 0;
  GLX_FUNCTIONS(X)
#undef X
  return 1;
}

typedef struct Client {
  const Glx* glx;
  Display* display;
  XVisualInfo* visual;
  Window window;
} Client;

static inline Client openClient(const Glx* glx) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  Client client = {glx, openDisplay(), NULL, 0};
  client.visual = glx->ChooseVisual(client.display, DefaultScreen(client.display), wanted);
  if (!client.visual) {
    fprintf(stderr, "no visual\n");
    exit(1);
  }
  client.window = makeWindow(client.display, client.visual);
  return client;
}

static inline void closeClient(Client* client) {
  XDestroyWindow(client->display, client->window);
  XFree(client->visual);
  XCloseDisplay(client->display);
}

static inline void showClient(void* user) {
  const Client* client = (const Client*)user;
  client->glx->SwapBuffers(client->display, client->window);
}

/* Window, legacy context, frames, end. 0 (success) if the image was right. */
static inline int runGlxClient(const Glx* glx, const Gl* gl) {
  Client client = openClient(glx);
  GLXContext context = glx->CreateContext(client.display, client.visual, NULL, True);
  if (!context || !glx->MakeCurrent(client.display, client.window, context))
    return fprintf(stderr, "no context\n"), 1;
  const int right = workload(gl, showClient, &client);
  glx->MakeCurrent(client.display, None, NULL);
  glx->DestroyContext(client.display, context);
  closeClient(&client);
  return !right;
}
