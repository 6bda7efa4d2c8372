/* A plug-in that links libGL itself, as KiCad's editors and Java's native libraries do. */
#include "plugin.h"

#include "linked.h"

int pluginDraw(void (*show)(void*), void* user) {
  const Gl gl = linkedGl();
  glFinish(); /* through the procedure linkage table; the table above is filled when the plug-in is loaded */
  return workload(&gl, show, user);
}

/* Door.draw() for the Java virtual machine: makes a window and a context, and draws all frames. */
int Java_Door_draw(void* environment, void* class) {
  (void)environment;
  (void)class;
  const Gl gl = linkedGl();
  const Glx glx = linkedGlx();
  return runGlxClient(&glx, &gl);
}
