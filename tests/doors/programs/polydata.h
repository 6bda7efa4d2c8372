/* A mesh drawn as by VTK's polydata mapper: core profile, the array of each attribute in a buffer of its
   own, one indexed draw, uniforms of VTK's names (VTK 9, vtkPolyDataVS.glsl and what vtkOpenGLPolyDataMapper
   puts into it). Frames go to a framebuffer object and are written to standard output as PPM images. */
#pragma once
#define GL_GLEXT_PROTOTYPES /* for the types; nothing is linked */
#include <GL/gl.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// clang-format 14 never settles on a layout of such lists.
// clang-format off
#define POLYDATA_FUNCTIONS(X) \
  X(AttachShader) X(BindBuffer) X(BindFramebuffer) X(BindTexture) X(BindVertexArray) \
  X(BlendFuncSeparate) X(BufferData) X(CheckFramebufferStatus) X(Clear) X(ClearColor) \
  X(CompileShader) X(CreateProgram) X(CreateShader) X(DepthFunc) X(DrawRangeElements) X(Enable) \
  X(EnableVertexAttribArray) X(FramebufferTexture2D) X(GenBuffers) X(GenFramebuffers) \
  X(GenTextures) X(GenVertexArrays) X(GetAttribLocation) X(GetError) X(GetProgramInfoLog) \
  X(GetProgramiv) X(GetString) X(GetUniformLocation) X(LinkProgram) X(PixelStorei) \
  X(ReadPixels) X(Scissor) X(ShaderSource) X(TexImage2D) X(TexParameteri) X(Uniform1f) \
  X(Uniform1i) X(Uniform3fv) X(UniformMatrix3fv) X(UniformMatrix4fv) X(UseProgram) \
  X(VertexAttribPointer) X(Viewport)
// clang-format on

typedef struct Functions {
#define X(name) __typeof__(&gl##name) name;
  POLYDATA_FUNCTIONS(X)
#undef X
} Functions;

typedef void* (*FunctionLookup)(const char* name);

/* Like glad: looks every name up once a context exists. */
static inline int loadFunctions(Functions* gl, FunctionLookup lookup) {
#define X(name) \
  if (!(gl->name = (__typeof__(gl->name))lookup("gl" #name))) return fprintf(stderr, "no gl" #name "\n"), 0;
  POLYDATA_FUNCTIONS(X)
#undef X
  return 1;
}

static const char kVertexShader[] =
    "#version 150\n"
    "in vec4 vertexMC;\nin vec3 normalMC;\n"
    "uniform mat3 normalMatrix;\nuniform mat4 MCDCMatrix;\nuniform mat4 MCVCMatrix;\n"
    "out vec3 normalVCVSOutput;\nout vec4 vertexVCVSOutput;\n"
    "void main() {\n"
    "  normalVCVSOutput = normalMatrix * normalMC;\n"
    "  vertexVCVSOutput = MCVCMatrix * vertexMC;\n"
    "  gl_Position = MCDCMatrix * vertexMC;\n"
    "}\n";

static const char kFragmentShader[] =
    "#version 150\n"
    "in vec3 normalVCVSOutput;\nin vec4 vertexVCVSOutput;\n"
    "uniform float ambientIntensity;\nuniform float diffuseIntensity;\nuniform float specularIntensity;\n"
    "uniform vec3 ambientColorUniform;\nuniform vec3 diffuseColorUniform;\nuniform vec3 "
    "specularColorUniform;\n"
    "uniform float specularPowerUniform;\nuniform float opacityUniform;\n"
    "uniform vec3 lightColor0;\nuniform vec3 lightDirectionVC0;\n"
    "out vec4 fragOutput0;\n"
    "void main() {\n"
    "  vec4 vertexVC = vertexVCVSOutput;\n"
    "  vec3 specularColor = specularIntensity * specularColorUniform;\n"
    "  float specularPower = specularPowerUniform;\n"
    "  vec3 ambientColor = ambientIntensity * ambientColorUniform;\n"
    "  vec3 diffuseColor = diffuseIntensity * diffuseColorUniform;\n"
    "  float opacity = opacityUniform;\n"
    "  vec3 normalVCVSOutput = normalize(normalVCVSOutput);\n"
    "  if (gl_FrontFacing == false) { normalVCVSOutput = -normalVCVSOutput; }\n"
    "  vec3 diffuse = vec3(0,0,0);\n  vec3 specular = vec3(0,0,0);\n  float df;\n  float sf;\n"
    "  df = max(0.0, dot(normalVCVSOutput, -lightDirectionVC0));\n"
    "  diffuse += (df * lightColor0);\n"
    "  sf = sign(df)*pow(max(1e-5, dot(reflect(lightDirectionVC0, normalVCVSOutput), "
    "normalize(-vertexVC.xyz))), specularPower);\n"
    "  specular += (sf * lightColor0);\n"
    "  diffuse = diffuse * diffuseColor;\n  specular = specular * specularColor;\n"
    "  fragOutput0 = vec4(ambientColor + diffuse + specular, opacity);\n"
    "  if (fragOutput0.a <= 0.0) { discard; }\n"
    "}\n";

enum {
  kWidth = 320,
  kHeight = 240,
  kAround = 60,
  kAcross = 30,
  kPoints = kAround * kAcross,
  kIndices = kPoints * 6,
  kImages = 3
};

/* A torus whose tube swells and shrinks: positions, normals of the plain torus, triangles. */
static inline void makeMesh(float positions[][3], float normals[][3], GLuint* indices) {
  const double turn = 6.283185307179586;
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const double a = turn * i / kAround, b = turn * j / kAcross, radius = 0.35 + 0.08 * sin(5 * a);
      float* p = positions[i * kAcross + j];
      float* n = normals[i * kAcross + j];
      n[0] = (float)(cos(a) * cos(b)), n[1] = (float)(sin(a) * cos(b)), n[2] = (float)sin(b);
      p[0] = (float)(cos(a) + radius * n[0]), p[1] = (float)(sin(a) + radius * n[1]),
      p[2] = (float)(radius * n[2]);
      const GLuint corners[] = {(GLuint)(i * kAcross + j), (GLuint)((i + 1) % kAround * kAcross + j),
                                (GLuint)((i + 1) % kAround * kAcross + (j + 1) % kAcross),
                                (GLuint)(i * kAcross + (j + 1) % kAcross)};
      const int order[] = {0, 1, 2, 0, 2, 3};
      for (int k = 0; k < 6; ++k) *indices++ = corners[order[k]];
    }
}

static inline GLuint makeProgram(const Functions* gl) {
  const char* sources[] = {kVertexShader, kFragmentShader};
  const GLenum kinds[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
  const GLuint program = gl->CreateProgram();
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = gl->CreateShader(kinds[i]);
    gl->ShaderSource(shader, 1, &sources[i], NULL);
    gl->CompileShader(shader);
    gl->AttachShader(program, shader);
  }
  gl->LinkProgram(program);
  GLint linked = 0;
  gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  char text[2000] = "";
  gl->GetProgramInfoLog(program, sizeof text, NULL, text);
  fprintf(stderr, "%s\n", text);
  exit(1);
}

static inline GLuint makeTarget(const Functions* gl) {
  GLuint textures[2], framebuffer;
  gl->GenTextures(2, textures);
  gl->GenFramebuffers(1, &framebuffer);
  gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  for (int i = 0; i < 2; ++i) {
    gl->BindTexture(GL_TEXTURE_2D, textures[i]);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexImage2D(GL_TEXTURE_2D, 0, i ? GL_DEPTH24_STENCIL8 : GL_RGBA8, kWidth, kHeight, 0,
                   i ? GL_DEPTH_STENCIL : GL_RGBA, i ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_BYTE, NULL);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                             textures[i], 0);
  }
  if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return framebuffer;
  fprintf(stderr, "the framebuffer is not complete\n");
  exit(1);
}

static inline void fillArray(const Functions* gl, GLuint program, GLuint buffer, const char* name,
                             const void* data) {
  const GLint place = gl->GetAttribLocation(program, name);
  gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl->BufferData(GL_ARRAY_BUFFER, kPoints * 3 * sizeof(float), data, GL_STATIC_DRAW);
  gl->VertexAttribPointer((GLuint)place, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), NULL);
  gl->EnableVertexAttribArray((GLuint)place);
}

static inline void setColor(const Functions* gl, GLuint program, const char* name, float r, float g,
                            float b) {
  const float color[] = {r, g, b};
  gl->Uniform3fv(gl->GetUniformLocation(program, name), 1, color);
}

static inline void setNumber(const Functions* gl, GLuint program, const char* name, float value) {
  gl->Uniform1f(gl->GetUniformLocation(program, name), value);
}

static inline void setMaterial(const Functions* gl, GLuint program) {
  setNumber(gl, program, "ambientIntensity", 0.1f);
  setNumber(gl, program, "diffuseIntensity", 0.8f);
  setNumber(gl, program, "specularIntensity", 0.4f);
  setNumber(gl, program, "specularPowerUniform", 20);
  setNumber(gl, program, "opacityUniform", 1);
  setColor(gl, program, "ambientColorUniform", 1, 1, 1);
  setColor(gl, program, "diffuseColorUniform", 0.9f, 0.6f, 0.3f);
  setColor(gl, program, "specularColorUniform", 1, 1, 1);
  setColor(gl, program, "lightColor0", 1, 1, 0.9f);
  setColor(gl, program, "lightDirectionVC0", -0.48f, -0.6f, -0.64f);
}

/* The camera turns about the x axis, five units away. Matrices column by column. */
static inline void setCamera(const Functions* gl, GLuint program, float angle) {
  const float c = cosf(angle), s = sinf(angle), near = 3, far = 8, focus = 3.2f;
  const float eye[] = {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, -5, 1};
  const float normal[] = {1, 0, 0, 0, c, s, 0, -s, c};
  const float projection[] = {
      focus * kHeight / kWidth,      0, 0, 0, 0, focus, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
      2 * far * near / (near - far), 0};
  float clip[16];
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) {
      clip[4 * column + row] = 0;
      for (int k = 0; k < 4; ++k) clip[4 * column + row] += projection[4 * k + row] * eye[4 * column + k];
    }
  gl->UniformMatrix4fv(gl->GetUniformLocation(program, "MCDCMatrix"), 1, GL_FALSE, clip);
  gl->UniformMatrix4fv(gl->GetUniformLocation(program, "MCVCMatrix"), 1, GL_FALSE, eye);
  gl->UniformMatrix3fv(gl->GetUniformLocation(program, "normalMatrix"), 1, GL_FALSE, normal);
}

static inline void writeImage(const Functions* gl) {
  static unsigned char pixels[kHeight][kWidth][3];
  gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl->ReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  printf("P6\n%d %d\n255\n", kWidth, kHeight);
  for (int row = kHeight; row-- > 0;) fwrite(pixels[row], 1, sizeof pixels[row], stdout);
}

/* Draws all frames with the current context; 0 if OpenGL reports an error. */
static inline int drawPolydata(const Functions* gl) {
  static float positions[kPoints][3], normals[kPoints][3];
  static GLuint indices[kIndices];
  makeMesh(positions, normals, indices);
  GLuint buffers[3], vertexArray;
  const GLuint program = makeProgram(gl), framebuffer = makeTarget(gl);
  gl->GenVertexArrays(1, &vertexArray);
  gl->BindVertexArray(vertexArray);
  gl->GenBuffers(3, buffers);
  fillArray(gl, program, buffers[0], "vertexMC", positions);
  fillArray(gl, program, buffers[1], "normalMC", normals);
  gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
  gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  for (int i = 0; i < kImages; ++i) {
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->Viewport(0, 0, kWidth, kHeight);
    gl->Scissor(0, 0, kWidth, kHeight);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LEQUAL);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->ClearColor(0.3f, 0.3f, 0.4f, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->UseProgram(program);
    setMaterial(gl, program);
    setCamera(gl, program, 0.5f + 0.6f * (float)i);
    gl->DrawRangeElements(GL_TRIANGLES, 0, kPoints - 1, kIndices, GL_UNSIGNED_INT, NULL);
    writeImage(gl);
  }
  const GLenum error = gl->GetError();
  if (error) fprintf(stderr, "OpenGL error 0x%x\n", error);
  return error == GL_NO_ERROR;
}
