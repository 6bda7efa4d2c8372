/* Functions through a loader library: built with GLEW (USE_GLEW) and with libepoxy. Both know some functions
   only after a context is current, so the context is made with GLX as linked. */
#ifdef USE_GLEW
#include <GL/glew.h>
#else
#include <epoxy/gl.h>
#include <epoxy/glx.h>
#endif

#include "glx_client.h"

int main(void) {
  Gl gl;
  Glx glx;
#define X(name) glx.name = glX##name;
  GLX_FUNCTIONS(X)
#undef X
  Client client = openClient(&glx);
  GLXContext context = glx.CreateContext(client.display, client.visual, NULL, True);
  if (!context || !glx.MakeCurrent(client.display, client.window, context))
    return fprintf(stderr, "no context\n"), 1;
#ifdef USE_GLEW
  if (glewInit() != GLEW_OK) return fprintf(stderr, "glewInit failed\n"), 1;
  GLuint buffer = 0;
  glGenBuffers(1, &buffer); /* GL 1.5: through GLEW's own pointer */
  if (!buffer) return 1;
#endif
#define X(ret, name, args) gl.name = gl##name;
  GL_FUNCTIONS(X)
#undef X
  const int right = workload(&gl, showClient, &client);
  glx.MakeCurrent(client.display, None, NULL);
  glx.DestroyContext(client.display, context);
  closeClient(&client);
  return !right;
}
