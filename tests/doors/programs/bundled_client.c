/* A program with a bundled OpenGL library: prints how it was started. */
#include <stdio.h>
#include <stdlib.h>

const unsigned char* glGetString(unsigned name);

int main(void) {
  const char* preload = getenv("LD_PRELOAD");
  puts(preload ? preload : "none");
  return glGetString(0x1F02) ? 0 : 1;
}
