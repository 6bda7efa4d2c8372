/* Copies pixels of the current context's window into the program's memory. */
#pragma once
#include <GL/gl.h>

/* Where pixels go. */
typedef struct Memory {
  void* pixels;
  GLenum format;       /* OSMESA_RGBA ... */
  GLint width, height; /* of the window */
  GLint rowLength;     /* pixels from row to row; 0: width */
  int yUp;             /* the first row is the lowest one */
} Memory;

/* Whether memory may hold pixels of this format and type. */
int osmesaCanHold(GLenum format, GLenum type);
/* Copies the colours. Changes no state of OpenGL. */
void osmesaCopyColors(const Memory* memory);
/* Copies depths as unsigned integers of `bytes` bytes, 2 or 4. Changes no state of OpenGL. 0: out of memory.
 */
int osmesaCopyDepths(const Memory* memory, int bytes);
