/* OpenGL's functions, taken from libOpenGL itself: this library and preloaded ones export the same names. Any
 * thread. */
#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

typedef struct Calls {
  void (*BindBuffer)(GLenum, GLuint);
  void (*BindFramebuffer)(GLenum, GLuint);
  void (*ClampColor)(GLenum, GLenum);
  void (*Finish)(void);
  void (*Flush)(void);
  void (*GetIntegerv)(GLenum, GLint*);
  void (*PixelStorei)(GLenum, GLint);
  void (*PopAttrib)(void);
  void (*PushAttrib)(GLbitfield);
  void (*PixelTransferf)(GLenum, GLfloat);
  void (*PixelTransferi)(GLenum, GLint);
  void (*ReadBuffer)(GLenum);
  void (*ReadPixels)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*);
} Calls;

/* Null: a function is missing. */
const Calls* osmesaCalls(void);
