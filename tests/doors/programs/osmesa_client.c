/* OpenGL into memory: OSMesa. A finished frame is a glFinish; there is no swap. */
#include "intercept/window_systems/osmesa_api.h"
#include "workload.h"

static unsigned char pixels[kWindowSize * kWindowSize * 4];

int main(void) {
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
  if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWindowSize, kWindowSize))
    return fprintf(stderr, "no context\n"), 1;
  Gl gl;
#define X(ret, name, args) gl.name = gl##name;
  GL_FUNCTIONS(X)
#undef X
  const int right = workload(&gl, NULL, NULL);
  const unsigned char* middle = pixels + 4 * (kWindowSize / 2 * kWindowSize + kWindowSize / 2);
  OSMesaDestroyContext(context);
  return !(right && middle[0] > 250 && middle[1] < 5);
}
