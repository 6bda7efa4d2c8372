/* The workload of every door test once it has a context: fixed numbers of calls, so that the test can check
   that each was seen, and an image whose colour it knows. tests/doors/check.py knows the numbers. */
#pragma once
#include <GL/gl.h>
#include <stdio.h>

enum { kFrames = 10, kTrianglesPerFrame = 50, kQueriesPerFrame = 20, kWindowSize = 64 };

// clang-format off: its layout of such lists never settles
#define GL_FUNCTIONS(X)                                                        \
  X(void, Clear, (GLbitfield))                                                 \
  X(void, ClearColor, (GLclampf, GLclampf, GLclampf, GLclampf))                \
  X(void, Enable, (GLenum))                                                    \
  X(void, Begin, (GLenum))                                                     \
  X(void, End, (void))                                                         \
  X(void, Vertex3f, (GLfloat, GLfloat, GLfloat))                               \
  X(void, Color3f, (GLfloat, GLfloat, GLfloat))                                \
  X(GLboolean, IsTexture, (GLuint))                                            \
  X(void, Finish, (void))                                                      \
  X(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)) \
  X(const GLubyte*, GetString, (GLenum))
// clang-format on

/* The OpenGL functions that the program found: linked, by dlsym, by GetProcAddress. */
typedef struct Gl {
#define X(ret, name, args) ret(*name) args;
  GL_FUNCTIONS(X)
#undef X
} Gl;

typedef void* (*GlLookup)(const char* name);

/* Fills the table; 0 if a function is missing. */
static inline int loadGl(Gl* gl, GlLookup lookup) {
#define X(ret, name, args) \
  if (!(gl->name = (ret(*) args)lookup("gl" #name))) return fprintf(stderr, "no gl" #name "\n"), 0;
  GL_FUNCTIONS(X)
#undef X
  return 1;
}

/* One frame: queries that change nothing, and red triangles over the middle of a black image. */
static inline void drawFrame(const Gl* gl) {
  gl->ClearColor(0, 0, 0, 1);
  gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl->Enable(GL_DEPTH_TEST);
  for (int i = 0; i < kQueriesPerFrame; ++i) gl->IsTexture(1);
  gl->Color3f(1, 0, 0);
  gl->Begin(GL_TRIANGLES);
  for (int i = 0; i < kTrianglesPerFrame; ++i) {
    const float z = -0.5f + 0.01f * (float)i;
    gl->Vertex3f(-0.9f, -0.9f, z);
    gl->Vertex3f(0.9f, -0.9f, z);
    gl->Vertex3f(0, 0.9f, z);
  }
  gl->End();
}

/* Whether the middle of the image is red. */
static inline int middleIsRed(const Gl* gl) {
  unsigned char pixel[4] = {0, 0, 0, 0};
  gl->ReadPixels(kWindowSize / 2, kWindowSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  if (pixel[0] > 250 && pixel[1] < 5 && pixel[2] < 5) return 1;
  fprintf(stderr, "the middle of the image is %d %d %d, not red\n", pixel[0], pixel[1], pixel[2]);
  return 0;
}

/* The same, after glFinish. */
static inline int imageIsRight(const Gl* gl) {
  gl->Finish();
  return middleIsRed(gl);
}

/* All frames; `show` swaps buffers. 1 if the image is right. */
static inline int workload(const Gl* gl, void (*show)(void*), void* user) {
  int right = 1;
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(gl);
    right = imageIsRight(gl) && right;
    if (show) show(user);
  }
  return right;
}
