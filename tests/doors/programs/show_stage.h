/* The window of show_client, what its cases draw, and how they write what they see as PPMs to standard
 * output. */
#pragma once
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <X11/Xlib.h>

extern Display* display;
extern Window window;
extern XVisualInfo* visual;
extern GLXContext context;
extern int width, height; /* of the window, at most 320 */

/* The window's content, as the user sees it. */
void window_shows(void);
/* The buffers, as the program reads them: colours, and the higher bytes of depths. */
void buffer_holds(void);

void swap(void);
void clear(void);
/* Two intersecting triangles. */
void surface(float turn);
/* clear(), surface(), swap() */
void frame(float turn);
/* Lines in space: their pixels depend on the depth buffer. */
void lines(void);
/* A framebuffer object of the window's size with colour, depth and stencil; binds the window's. */
GLuint framebuffer_of(int samples);

struct ShowCase {
  const char* name; /* NULL behind the last one */
  void (*run)(void);
};
#define CASE(name) \
  { #name, name }
extern const struct ShowCase kClearCases[];
