// A stage for shader programs (program_text.h): meshes in buffer objects, views, uniforms, and the comparison
// with the real OpenGL. For the program_*_test.cpp.
#pragma once
#include "tests/support/program_text.h"
#include "tests/support/traced_context.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace gluray::test {

using Gl = const gl::RealGl&;

/// Compiles and links; if that fails, 0 and a test failure. `geometry`: may be empty.
GLuint makeProgram(Gl gl, const std::string& vertex, const std::string& fragment,
                   const std::string& geometry = "");
inline GLuint makeProgram(Gl gl, const Surface& s) {
  return makeProgram(gl, vertexText(s), fragmentText(s), geometryText(s));
}

/// A new buffer with these values, bound to `target`.
template <class T>
GLuint makeBuffer(Gl gl, GLenum target, const std::vector<T>& values) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
  return name;
}

struct ProgramMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<uint32_t> colors;  // RGBA8
  std::vector<glm::vec2> texcoords;
  std::vector<GLuint> indices;
  GLsizei count() const { return static_cast<GLsizei>(indices.size()); }
  size_t triangles() const { return indices.size() / 3; }
};
/// A wavy surface of n x n squares over [-1, 1]^2 with normals towards +z and a colour at each vertex.
ProgramMesh sheet(int n);
/// A ball of radius 1 with outward triangles.
ProgramMesh ball(int n);

/// A mesh in buffers of its own behind a vertex array object, bound to the attributes that `program` has.
struct Upload {
  GLuint array = 0, positions = 0, normals = 0, colors = 0, texcoords = 0, indices = 0;
};
Upload upload(Gl gl, const ProgramMesh& mesh, GLuint program);

/// A camera and a place.
struct View {
  glm::dmat4 eyeFromObject{1}, clipFromEye{1};
};
/// Looks at the origin from a distance of 4, rotated by `degrees` about an oblique axis.
View perspectiveView(double degrees = 0);
View parallelView(double degrees = 0);
void setView(Gl gl, GLuint program, const View& view);

// Uniforms of the program in use; names that are not active are ignored, as OpenGL does.
void setInteger(Gl gl, GLuint program, const char* name, int value);
void setFloat(Gl gl, GLuint program, const char* name, float value);
void setVec3(Gl gl, GLuint program, const char* name, const glm::vec3& value);
void setMat4(Gl gl, GLuint program, const char* name, const glm::mat4& value);
void setMat3(Gl gl, GLuint program, const char* name, const glm::mat3& value);
/// Material, lights and the view, as VTK sets them all before a draw.
void setAll(Gl gl, GLuint program, const View& view, const Surface& surface);
/// Width, colour and opacity of edges, and the viewport (tests/support/edges_text.h).
void setEdges(Gl gl, GLuint program);

/// A buffer texture with one texel for each triangle on `unit`: RGBA8 colours, or RGBA32F normals of the
/// triangles.
void cellColors(Gl gl, const ProgramMesh& mesh, GLenum unit, size_t before = 0);
void cellNormals(Gl gl, const ProgramMesh& mesh, GLenum unit, size_t before = 0);
/// Textures on `unit`: VTK's colour map of 8 colours (nearest, clamped), and a chequered image without
/// alpha.
void colorMap(Gl gl, GLenum unit);
void chequers(Gl gl, GLenum unit);

/// Clears, and sets state for a VTK frame: depth function LEQUAL, blending on.
void beginFrame(Gl gl);
/// Uses the program, sets all, draws the mesh.
void drawSurface(Gl gl, GLuint program, const Upload& up, const ProgramMesh& mesh, const View& view,
                 const Surface& surface);

/// A program of no family: it paints stripes. It transforms vertices as the others do.
GLuint makeUnknownProgram(Gl gl);
void drawByUnknown(Gl gl, GLuint program, const Upload& up, const ProgramMesh& mesh, const View& view);

inline constexpr int kProgramWidth = 200, kProgramHeight = 150;
/// Tolerance where both light each pixel: only edges differ, and roundings of 1/255.
inline constexpr scenes::Tolerance kProgramTolerance = {
    2, 0.002, 1e-5f, "silhouettes and folds fall on either side of a pixel's centre"};

struct Outcome {
  gl::Statistics statistics;
  DrawnImage expected, got;
};
using DrawProgram = std::function<void(Gl)>;
/// Draws with the real OpenGL and through GLuRay; expects the same image, no error, and the same state
/// afterwards. `draws`: how many must be traced; negative: any number. `families`: text of a family file;
/// empty: the built-in families.
Outcome expectSame(const std::string& name, const DrawProgram& draw, int draws, ContextWish wish = {},
                   const scenes::Tolerance& tolerance = kProgramTolerance, const std::string& families = "");
/// The same while tracing fails at the first flush: the real OpenGL draws from what each draw has kept.
void expectSameWhenTracingFails(const std::string& name, const DrawProgram& draw, ContextWish wish = {},
                                const std::string& families = "");
/// Both of these, with one image of the real OpenGL; the last three arguments as above.
void expectBoth(const std::string& name, const DrawProgram& draw, int draws, const ContextWish& wish = {},
                const scenes::Tolerance& tolerance = kProgramTolerance, const std::string& families = "");

/// The default context: core 3.2.
inline ContextWish coreWish(int major = 3, int minor = 2) {
  return {kProgramWidth, kProgramHeight, true, major, minor};
}

}  // namespace gluray::test
