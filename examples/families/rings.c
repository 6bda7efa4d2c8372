/* An example for docs/program-families.md: rings under a lamp, drawn by a shader program of its own
   (GLSL 1.50, core profile) as tutorials write them: matrices model, view and projection, Blinn and Phong's
   light in world space.

     rings [FRAMES [IMAGE.ppm]]      FRAMES: 0 (default) goes on until it is ended; the image is that of
   the last */
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWidth = 480, kHeight = 360, kAround = 160, kAcross = 80, kRings = 5 };

static const char* const kVertexShader =
    "#version 150\n"
    "in vec3 position;\n"
    "in vec3 normal;\n"
    "uniform mat4 model, view, projection;\n"
    "out vec3 worldPosition, worldNormal;\n"
    "void main() {\n"
    "  vec4 world = model * vec4(position, 1.0);\n"
    "  worldPosition = world.xyz;\n"
    "  worldNormal = mat3(model) * normal;\n"
    "  gl_Position = projection * view * world;\n"
    "}\n";

static const char* const kFragmentShader =
    "#version 150\n"
    "in vec3 worldPosition, worldNormal;\n"
    "uniform vec3 lightPosition, lightColor, viewPosition, uColor;\n"
    "uniform float ambient, gloss, shininess;\n"
    "out vec4 color;\n"
    "void main() {\n"
    "  vec3 n = normalize(worldNormal);\n"
    "  vec3 toLight = normalize(lightPosition - worldPosition);\n"
    "  vec3 toViewer = normalize(viewPosition - worldPosition);\n"
    "  float diffuse = max(dot(n, toLight), 0.0);\n"
    "  float shine = diffuse > 0.0 ? pow(max(dot(n, normalize(toLight + toViewer)), 0.0), shininess) : 0.0;\n"
    "  color = vec4(uColor * (ambient + diffuse * lightColor) + gloss * shine * lightColor, 1.0);\n"
    "}\n";

static void fail(const char* what) {
  fprintf(stderr, "rings: %s\n", what);
  exit(1);
}

/* --- 4x4 matrices, column by column
 * ------------------------------------------------------------------------- */

typedef struct Matrix {
  float m[16];
} Matrix;

static Matrix times(Matrix a, Matrix b) {
  Matrix c;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      c.m[4 * i + j] = 0;
      for (int k = 0; k < 4; ++k) c.m[4 * i + j] += a.m[4 * k + j] * b.m[4 * i + k];
    }
  return c;
}
static Matrix perspective(float fieldOfView, float aspect, float near, float far) {
  const float f = 1 / tanf(fieldOfView / 2);
  return (Matrix){{f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
                   2 * far * near / (near - far), 0}};
}
static Matrix moved(float x, float y, float z) {
  return (Matrix){{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}};
}
static Matrix turnedX(float a) {
  return (Matrix){{1, 0, 0, 0, 0, cosf(a), sinf(a), 0, 0, -sinf(a), cosf(a), 0, 0, 0, 0, 1}};
}
static Matrix turnedY(float a) {
  return (Matrix){{cosf(a), 0, -sinf(a), 0, 0, 1, 0, 0, sinf(a), 0, cosf(a), 0, 0, 0, 0, 1}};
}

/* --- Window, program, mesh
 * ------------------------------------------------------------------------------------ */

static GLXDrawable openWindow(Display* display) {
  const int wish[] = {
      GLX_RENDER_TYPE,   GLX_RGBA_BIT,   GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, GLX_DOUBLEBUFFER, True,
      GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT, None};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wish, &count);
  XVisualInfo* visual = count ? glXGetVisualFromFBConfig(display, configs[0]) : NULL;
  if (!visual) fail("no window with colour and depth");
  XSetWindowAttributes attributes = {0};
  attributes.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
  attributes.event_mask = StructureNotifyMask;
  const Window window =
      XCreateWindow(display, DefaultRootWindow(display), 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput,
                    visual->visual, CWColormap | CWEventMask | CWBorderPixel, &attributes);
  XStoreName(display, window, "rings");
  XMapWindow(display, window);
  for (XEvent event; XNextEvent(display, &event), event.type != MapNotify;) {}
  const int version[] = {
      GLX_CONTEXT_MAJOR_VERSION_ARB,    3,   GLX_CONTEXT_MINOR_VERSION_ARB, 2, GLX_CONTEXT_PROFILE_MASK_ARB,
      GLX_CONTEXT_CORE_PROFILE_BIT_ARB, None};
  const PFNGLXCREATECONTEXTATTRIBSARBPROC create =
      (PFNGLXCREATECONTEXTATTRIBSARBPROC)glXGetProcAddressARB((const GLubyte*)"glXCreateContextAttribsARB");
  const GLXContext context = create ? create(display, configs[0], NULL, True, version) : NULL;
  if (!context || !glXMakeCurrent(display, window, context)) fail("no OpenGL 3.2");
  XFree(visual), XFree(configs);
  return window;
}

static void compile(GLuint program, GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  GLint well = 0;
  glShaderSource(shader, 1, &text, NULL);
  glCompileShader(shader);
  glGetShaderiv(shader, GL_COMPILE_STATUS, &well);
  if (!well) fail("a shader does not compile");
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

static GLuint makeProgram(void) {
  const GLuint program = glCreateProgram();
  GLint well = 0;
  compile(program, GL_VERTEX_SHADER, kVertexShader);
  compile(program, GL_FRAGMENT_SHADER, kFragmentShader);
  glLinkProgram(program);
  glGetProgramiv(program, GL_LINK_STATUS, &well);
  if (!well) fail("the program does not link");
  glUseProgram(program);
  return program;
}

static void setArray(GLuint program, const char* name, const float* values, size_t bytes) {
  const GLuint place = (GLuint)glGetAttribLocation(program, name);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, values, GL_STATIC_DRAW);
  glVertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(place);
}

/* A ring of radius 1 as vertex array object, with `thickness` across. */
static void makeRing(GLuint program, float thickness) {
  static float positions[kAround * kAcross][3], normals[kAround * kAcross][3];
  static GLuint indices[kAround * kAcross * 6];
  int n = 0;
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const float u = 6.2831853f * (float)i / kAround, v = 6.2831853f * (float)j / kAcross;
      const int k = i * kAcross + j;
      const float normal[3] = {cosf(u) * cosf(v), sinf(v), sinf(u) * cosf(v)};
      for (int c = 0; c < 3; ++c) normals[k][c] = normal[c], positions[k][c] = thickness * normal[c];
      positions[k][0] += cosf(u), positions[k][2] += sinf(u);
      const int i1 = (i + 1) % kAround, j1 = (j + 1) % kAcross;
      const int corners[6] = {k, i * kAcross + j1, i1 * kAcross + j1, k, i1 * kAcross + j1, i1 * kAcross + j};
      for (int c = 0; c < 6; ++c) indices[n++] = (GLuint)corners[c];
    }
  GLuint array = 0, buffer = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  setArray(program, "position", positions[0], sizeof positions);
  setArray(program, "normal", normals[0], sizeof normals);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
}

/* --- Frames
 * ----------------------------------------------------------------------------------------------------- */

static void setMatrix(GLuint program, const char* name, Matrix m) {
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, m.m);
}
static void setVector(GLuint program, const char* name, float x, float y, float z) {
  glUniform3f(glGetUniformLocation(program, name), x, y, z);
}
static void setNumber(GLuint program, const char* name, float x) {
  glUniform1f(glGetUniformLocation(program, name), x);
}

static void drawFrame(GLuint program, int frame) {
  const float turn = 0.02f * (float)frame, distance = 5;
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setMatrix(program, "projection", perspective(0.7f, (float)kWidth / kHeight, 1, 20));
  setMatrix(program, "view", times(moved(0, 0, -distance), turnedY(-turn)));
  setVector(program, "viewPosition", distance * sinf(turn), 0, distance * cosf(turn));
  setVector(program, "lightPosition", 2, 4, 3);
  setVector(program, "lightColor", 1, 0.95f, 0.85f);
  setNumber(program, "ambient", 0.15f);
  setNumber(program, "gloss", 0.6f);
  setNumber(program, "shininess", 40);
  for (int i = 0; i < kRings; ++i) {
    const float t = (float)i / (kRings - 1);
    setMatrix(program, "model",
              times(moved(1.6f * t - 0.8f, 0, 0.3f * t), turnedX(1.5707963f * (float)(i % 2))));
    setVector(program, "uColor", 0.9f - 0.7f * t, 0.3f + 0.3f * t, 0.2f + 0.7f * t);
    glDrawElements(GL_TRIANGLES, kAround * kAcross * 6, GL_UNSIGNED_INT, NULL);
  }
}

static void writeImage(const char* file) {
  static unsigned char pixels[kHeight][kWidth][3];
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  FILE* out = fopen(file, "wb");
  if (!out) fail("cannot write the image");
  fprintf(out, "P6\n%d %d\n255\n", kWidth, kHeight);
  for (int y = kHeight - 1; y >= 0; --y) fwrite(pixels[y], 3, kWidth, out);
  fclose(out);
}

int main(int count, char** words) {
  const int frames = count > 1 ? atoi(words[1]) : 0;
  Display* display = XOpenDisplay(NULL);
  if (!display) fail("no display");
  const GLXDrawable window = openWindow(display);
  const GLuint program = makeProgram();
  makeRing(program, 0.2f);
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.1f, 0.1f, 0.12f, 1);
  for (int frame = 0; frames == 0 || frame < frames; ++frame) {
    drawFrame(program, frame);
    if (frame == frames - 1 && count > 2) writeImage(words[2]);
    glXSwapBuffers(display, window);
  }
  return 0;
}
