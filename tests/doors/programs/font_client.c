/* Text by glXUseXFont: prints how many pixels are lit and a checksum of the image. */
#include "linked.h"

int main(void) {
  static unsigned char pixels[kWindowSize * kWindowSize];
  const Glx glx = linkedGlx();
  Client client = openClient(&glx);
  GLXContext context = glXCreateContext(client.display, client.visual, NULL, True);
  glXMakeCurrent(client.display, client.window, context);
  const Font font = XLoadFont(client.display, "fixed");
  const GLuint base = glGenLists(128);
  glXUseXFont(font, 0, 128, (int)base);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glColor3f(1, 1, 1);
  glRasterPos2f(-0.8f, 0);
  glListBase(base);
  glCallLists(5, GL_UNSIGNED_BYTE, "H8h@x");
  glReadPixels(0, 0, kWindowSize, kWindowSize, GL_RED, GL_UNSIGNED_BYTE, pixels);
  unsigned lit = 0, sum = 0;
  for (unsigned i = 0; i < sizeof pixels; ++i) {
    lit += pixels[i] != 0;
    sum = sum * 31 + pixels[i];
  }
  printf("%u %u %u\n", lit, sum, glGetError());
  return lit == 0;
}
