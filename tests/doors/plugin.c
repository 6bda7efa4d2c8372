/* A plug-in that links libGL itself, as KiCad's editors and Java's native libraries do. */
#include "plugin.h"

#include "linked.h"

int pluginDraw(void (*show)(void*), void* user) {
  const Gl gl = linkedGl();
  glFinish(); /* by the procedure linkage table; the table above is filled when the plug-in is loaded */
  return workload(&gl, show, user);
}

/* What the Java virtual machine calls Door.draw(): a window, a context and all frames. */
int Java_Door_draw(void* environment, void* class) {
  (void)environment;
  (void)class;
  const Gl gl = linkedGl();
  const Glx glx = linkedGlx();
  return runGlxClient(&glx, &gl);
}
