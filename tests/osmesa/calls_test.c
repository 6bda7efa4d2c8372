/* OSMesa's calls, as a program that opens the library sees them: osmesa_calls LIBRARY. Prints what is wrong;
 * the exit code is the number of faults. */
#include "intercept/window_systems/osmesa_api.h"

#include <GL/glext.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kWidth = 6, kHeight = 4, kRow = 9 };

static int g_faults;

static void expect(int right, const char* what) {
  if (right) return;
  ++g_faults;
  printf("not so: %s\n", what);
}
#define EXPECT(CONDITION) expect((CONDITION) != 0, #CONDITION)

#define CALLS(X)                \
  X(OSMesaCreateContext)        \
  X(OSMesaCreateContextExt)     \
  X(OSMesaCreateContextAttribs) \
  X(OSMesaDestroyContext)       \
  X(OSMesaMakeCurrent)          \
  X(OSMesaGetCurrentContext)    \
  X(OSMesaPixelStore)           \
  X(OSMesaGetIntegerv) X(OSMesaGetDepthBuffer) X(OSMesaGetColorBuffer) X(OSMesaGetProcAddress)
#define DECLARE(NAME) static __typeof__(&NAME) p##NAME;
CALLS(DECLARE)

static void (*pClear)(GLbitfield), (*pClearColor)(GLfloat, GLfloat, GLfloat, GLfloat),
    (*pClearDepth)(GLdouble), (*pEnable)(GLenum), (*pScissor)(GLint, GLint, GLsizei, GLsizei),
    (*pFinish)(void), (*pFlush)(void), (*pPixelStorei)(GLenum, GLint), (*pGetIntegerv)(GLenum, GLint*),
    (*pGenTextures)(GLsizei, GLuint*), (*pBindTexture)(GLenum, GLuint), (*pDisable)(GLenum),
    (*pPixelTransferf)(GLenum, GLfloat);
static GLenum (*pGetError)(void);
static const GLubyte* (*pGetString)(GLenum);
static GLboolean (*pIsTexture)(GLuint);

static void* g_library;

static void find(void* place, const char* name, int opengl) {
  void* const call = opengl ? (void*)pOSMesaGetProcAddress(name) : dlsym(g_library, name);
  if (!call) printf("missing: %s\n", name), exit(1);
  memcpy(place, &call, sizeof call);
}

static void findAll(const char* library) {
  g_library = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (!g_library) printf("%s\n", dlerror()), exit(77);
#define FIND(NAME) find(&p##NAME, #NAME, 0);
  CALLS(FIND)
#define FIND_GL(NAME) find(&p##NAME, "gl" #NAME, 1)
  FIND_GL(Clear);
  FIND_GL(ClearColor);
  FIND_GL(ClearDepth);
  FIND_GL(Enable);
  FIND_GL(Scissor);
  FIND_GL(Finish);
  FIND_GL(Flush);
  FIND_GL(PixelStorei);
  FIND_GL(GetIntegerv);
  FIND_GL(GenTextures);
  FIND_GL(BindTexture);
  FIND_GL(GetError);
  FIND_GL(GetString);
  FIND_GL(IsTexture);
  FIND_GL(Disable);
  FIND_GL(PixelTransferf);
  EXPECT(dlsym(g_library, "glFinish") != NULL);
  EXPECT(dlsym(g_library, "glClear") != NULL);
  EXPECT(pOSMesaGetProcAddress("OSMesaMakeCurrent") != NULL);
}

/* Red 1, green 0.2, blue 0.6, alpha 0.4; the lowest row and the left column are black and opaque. */
static void paint(void) {
  pDisable(GL_SCISSOR_TEST);
  pClearColor(0, 0, 0, 1);
  pClear(GL_COLOR_BUFFER_BIT);
  pEnable(GL_SCISSOR_TEST);
  pScissor(1, 1, kWidth, kHeight);
  pClearColor(1, 0.2f, 0.6f, 0.4f);
  pClear(GL_COLOR_BUFFER_BIT);
  pDisable(GL_SCISSOR_TEST);
}

static void testFormats(void) {
  static const struct {
    GLenum format;
    unsigned char bytes[4];
    int size;
  } kFormats[] = {{OSMESA_RGBA, {255, 51, 153, 102}, 4},
                  {OSMESA_BGRA, {153, 51, 255, 102}, 4},
                  {OSMESA_ARGB, {102, 255, 51, 153}, 4},
                  {OSMESA_RGB, {255, 51, 153}, 3},
                  {OSMESA_BGR, {153, 51, 255}, 3}};
  for (size_t i = 0; i < sizeof kFormats / sizeof *kFormats; ++i) {
    unsigned char pixels[kRow * kHeight * 4];
    const int size = kFormats[i].size;
    const OSMesaContext context = pOSMesaCreateContextExt(kFormats[i].format, 24, 8, 0, NULL);
    EXPECT(context != NULL);
    EXPECT(pOSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight));
    paint();
    pFinish();
    EXPECT(memcmp(pixels + (kWidth + 1) * size, kFormats[i].bytes, (size_t)size) == 0);
    EXPECT(pixels[0 + (kFormats[i].format == OSMESA_ARGB)] == 0);
    pOSMesaDestroyContext(context);
    EXPECT(pOSMesaGetCurrentContext() == NULL);
  }
  EXPECT(pOSMesaCreateContext(0x9999, NULL) == NULL);
}

static void testRows(void) {
  unsigned int pixels[kRow * kHeight];
  GLint value = -1;
  const OSMesaContext context = pOSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
  EXPECT(pOSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight));
  pOSMesaGetIntegerv(OSMESA_Y_UP, &value);
  EXPECT(value == 1);
  memset(pixels, 0x77, sizeof pixels);
  pOSMesaPixelStore(OSMESA_ROW_LENGTH, kRow);
  pOSMesaPixelStore(OSMESA_Y_UP, 0);
  pOSMesaGetIntegerv(OSMESA_ROW_LENGTH, &value);
  EXPECT(value == kRow);
  paint();
  pFlush(), pFinish();
  EXPECT(pixels[1] == 0x669933ffu);                        /* the highest row is the first one */
  EXPECT(pixels[(kHeight - 1) * kRow + 1] == 0xff000000u); /* the lowest is the last one */
  EXPECT(pixels[kWidth] == 0x77777777u);                   /* between rows */
  EXPECT(pixels[2 * kRow] == 0xff000000u);
  pOSMesaDestroyContext(context);
}

/* The program's state of reads is its own. */
static void testState(void) {
  unsigned int pixels[kRow * kHeight];
  GLint value = 0;
  const OSMesaContext context = pOSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
  EXPECT(pOSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight));
  pPixelStorei(GL_PACK_ROW_LENGTH, 3), pPixelStorei(GL_PACK_SKIP_ROWS, 2), pPixelStorei(GL_PACK_ALIGNMENT, 8);
  pPixelTransferf(GL_RED_SCALE, 0);
  paint();
  pFinish();
  EXPECT(pixels[kWidth + 1] == 0x669933ffu);
  pGetIntegerv(GL_PACK_ROW_LENGTH, &value);
  EXPECT(value == 3);
  pGetIntegerv(GL_PACK_ALIGNMENT, &value);
  EXPECT(value == 8);
  EXPECT(pGetError() == GL_NO_ERROR);
  pOSMesaDestroyContext(context);
}

static void testTwoContexts(void) {
  unsigned int first[kWidth * kHeight] = {0}, second[2 * kWidth * kHeight] = {0};
  GLint width = 0, height = 0, format = 0;
  GLuint texture = 0;
  void* buffer = NULL;
  const OSMesaContext a = pOSMesaCreateContext(OSMESA_RGBA, NULL), b = pOSMesaCreateContext(OSMESA_RGBA, a);
  EXPECT(pOSMesaMakeCurrent(a, first, GL_UNSIGNED_BYTE, kWidth, kHeight));
  pGenTextures(1, &texture), pBindTexture(GL_TEXTURE_2D, texture);
  paint();
  pFinish();
  EXPECT(pOSMesaMakeCurrent(b, second, GL_UNSIGNED_BYTE, 2 * kWidth, kHeight));
  EXPECT(pOSMesaGetCurrentContext() == b);
  EXPECT(pIsTexture(texture)); /* b shares what a has */
  GLint viewport[4] = {0};
  pGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT(viewport[2] == 2 * kWidth && viewport[3] == kHeight);
  pClearColor(0, 1, 0, 1), pClear(GL_COLOR_BUFFER_BIT), pFinish();
  EXPECT(second[2 * kWidth * kHeight - 1] == 0xff00ff00u);
  EXPECT(first[kWidth + 1] == 0x669933ffu);
  EXPECT(pOSMesaGetColorBuffer(b, &width, &height, &format, &buffer));
  EXPECT(width == 2 * kWidth && height == kHeight && format == OSMESA_RGBA && buffer == second);
  EXPECT(pOSMesaMakeCurrent(NULL, NULL, 0, 0, 0));
  EXPECT(pOSMesaGetCurrentContext() == NULL);
  pOSMesaDestroyContext(b), pOSMesaDestroyContext(a);
}

static void testOtherSizes(void) {
  unsigned int small[kWidth * kHeight], large[4 * kWidth * kHeight];
  const OSMesaContext context = pOSMesaCreateContext(OSMESA_RGBA, NULL);
  EXPECT(pOSMesaMakeCurrent(context, small, GL_UNSIGNED_BYTE, kWidth, kHeight));
  EXPECT(pOSMesaMakeCurrent(context, large, GL_UNSIGNED_BYTE, 2 * kWidth, 2 * kHeight));
  pClearColor(0, 0, 1, 1), pClear(GL_COLOR_BUFFER_BIT), pFinish();
  EXPECT(large[0] == 0xffff0000u && large[4 * kWidth * kHeight - 1] == 0xffff0000u);
  EXPECT(pOSMesaMakeCurrent(context, small, GL_UNSIGNED_BYTE, kWidth, kHeight));
  pClearColor(1, 0, 0, 1), pClear(GL_COLOR_BUFFER_BIT), pFinish();
  EXPECT(small[kWidth * kHeight - 1] == 0xff0000ffu && large[0] == 0xffff0000u);
  EXPECT(!pOSMesaMakeCurrent(context, small, GL_UNSIGNED_BYTE, 0, kHeight));
  EXPECT(!pOSMesaMakeCurrent(context, NULL, GL_UNSIGNED_BYTE, kWidth, kHeight));
  EXPECT(!pOSMesaMakeCurrent(context, small, GL_BITMAP, kWidth, kHeight));
  pOSMesaDestroyContext(context);
}

static void testDepths(void) {
  unsigned int pixels[kWidth * kHeight];
  GLint width = 0, height = 0, bytes = 0;
  void* depths = NULL;
  const OSMesaContext context = pOSMesaCreateContextExt(OSMESA_RGBA, 16, 0, 0, NULL);
  EXPECT(pOSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight));
  pClearDepth(0.5), pClear(GL_DEPTH_BUFFER_BIT), pFinish();
  EXPECT(pOSMesaGetDepthBuffer(context, &width, &height, &bytes, &depths));
  EXPECT(width == kWidth && height == kHeight && (bytes == 2 || bytes == 4) && depths != NULL);
  if (bytes == 2) EXPECT(abs(((unsigned short*)depths)[kWidth * kHeight - 1] - 0x8000) <= 1);
  pOSMesaDestroyContext(context);
}

static void testAttributes(void) {
  unsigned int pixels[kWidth * kHeight];
  const int core[] = {OSMESA_FORMAT,
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
  GLint profile = 0, major = 0;
  const OSMesaContext context = pOSMesaCreateContextAttribs(core, NULL);
  EXPECT(context != NULL);
  EXPECT(pOSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight));
  pGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile), pGetIntegerv(GL_MAJOR_VERSION, &major);
  EXPECT(profile == GL_CONTEXT_CORE_PROFILE_BIT && major >= 3);
  pClearColor(0, 0, 1, 1), pClear(GL_COLOR_BUFFER_BIT), pFinish();
  EXPECT(pixels[0] == 0xffff0000u);
  EXPECT(pGetError() == GL_NO_ERROR);
  pOSMesaDestroyContext(context);
  const int wrong[] = {OSMESA_PROFILE, 0x1234, 0}, unknown[] = {0x7777, 1, 0};
  EXPECT(pOSMesaCreateContextAttribs(wrong, NULL) == NULL);
  EXPECT(pOSMesaCreateContextAttribs(unknown, NULL) == NULL);
}

int main(int count, char** arguments) {
  if (count != 2) return fprintf(stderr, "usage: osmesa_calls LIBRARY\n"), 2;
  findAll(arguments[1]);
  testFormats(), testRows(), testState(), testTwoContexts(), testOtherSizes(), testDepths(), testAttributes();
  return g_faults;
}
