// Vertex arrays of shader programs in every layout: interleaved, of other types, without a buffer, as
// constants, and set by the commands of OpenGL 4.3 and 4.5.
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace gluray::test {
namespace {

/// A typical vertex layout.
struct InterleavedVertex {
  std::array<GLshort, 4> position;  // thousandths
  std::array<GLbyte, 4> normal;
  std::array<GLubyte, 4> color;
};

std::vector<InterleavedVertex> interleaved(const ProgramMesh& mesh) {
  std::vector<InterleavedVertex> all;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    InterleavedVertex v{};
    for (size_t k = 0; k < 3; ++k) {
      v.position[k] = static_cast<GLshort>(1000 * mesh.positions[i][static_cast<int>(k)]);
      v.normal[k] = static_cast<GLbyte>(127 * mesh.normals[i][static_cast<int>(k)]);
    }
    v.position[3] = 1;
    std::memcpy(v.color.data(), &mesh.colors[i], 4);
    all.push_back(v);
  }
  return all;
}

const Surface kSurface{.color = Surface::Color::vertex, .version = "#version 430\n"};

struct Stage {
  Gl gl;
  ProgramMesh mesh = ball(20);
  GLuint program = makeProgram(gl, kSurface);
  Upload up = upload(gl, mesh, program);
  GLuint at(const char* name) const { return static_cast<GLuint>(gl.GetAttribLocation(program, name)); }
  void begin(double scale = 1) {
    beginFrame(gl);
    gl.UseProgram(program);
    View view = perspectiveView(20);
    for (int c = 0; c < 3; ++c) view.eyeFromObject[c] *= scale;
    setAll(gl, program, view, kSurface);
    setMat3(gl, program, "normalMatrix", glm::mat3(perspectiveView(20).eyeFromObject));
    gl.BindVertexArray(up.array);
  }
  void draw() const { gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr); }
  template <class T>
  GLuint fill(const std::vector<T>& values) const {
    GLuint name = 0;
    gl.GenBuffers(1, &name), gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                  GL_STATIC_DRAW);
    return name;
  }
};

const void* offset(size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void interleavedShorts(Gl gl) {
  Stage s{gl};
  s.begin(0.001);
  s.fill(interleaved(s.mesh));
  gl.VertexAttribPointer(s.at("vertexMC"), 3, GL_SHORT, GL_FALSE, sizeof(InterleavedVertex), nullptr);
  gl.VertexAttribPointer(s.at("normalMC"), 3, GL_BYTE, GL_TRUE, sizeof(InterleavedVertex), offset(8));
  gl.VertexAttribPointer(s.at("scalarColor"), 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(InterleavedVertex),
                         offset(12));
  s.draw();
}

void doublesAndThreeBytes(Gl gl) {
  Stage s{gl};
  s.begin();
  std::vector<double> positions;
  for (const glm::vec3& p : s.mesh.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
  s.fill(positions);
  gl.VertexAttribPointer(s.at("vertexMC"), 3, GL_DOUBLE, GL_FALSE, 0, nullptr);
  std::vector<GLubyte> colors;
  for (const uint32_t c : s.mesh.colors)
    for (int k = 0; k < 3; ++k) colors.push_back(static_cast<GLubyte>(c >> 8 * k));
  s.fill(colors);
  gl.VertexAttribPointer(s.at("scalarColor"), 3, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  s.draw();
}

void positionsOfFour(Gl gl) {
  Stage s{gl};
  s.begin();
  std::vector<glm::vec4> positions;
  for (const glm::vec3& p : s.mesh.positions) positions.emplace_back(p, 1);
  s.fill(positions);
  gl.VertexAttribPointer(s.at("vertexMC"), 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  s.draw();
}

/// Points at w = 2 are not traced, but the image is the same.
void homogeneous(Gl gl) {
  Stage s{gl};
  s.begin();
  std::vector<glm::vec4> positions;
  for (const glm::vec3& p : s.mesh.positions) positions.emplace_back(p * 2.0f, 2);
  s.fill(positions);
  gl.VertexAttribPointer(s.at("vertexMC"), 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  s.draw();
}

void flatPositions(Gl gl) {
  Stage s{gl};
  s.begin();
  s.mesh = sheet(20);
  s.up = upload(gl, s.mesh, s.program);
  std::vector<glm::vec2> positions;
  for (const glm::vec3& p : s.mesh.positions) positions.emplace_back(p);
  s.fill(positions);
  gl.VertexAttribPointer(s.at("vertexMC"), 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  s.draw();
}

void constantColorAndNormal(Gl gl) {
  Stage s{gl};
  s.begin();
  gl.DisableVertexAttribArray(s.at("scalarColor")), gl.DisableVertexAttribArray(s.at("normalMC"));
  gl.VertexAttrib4f(s.at("scalarColor"), 0.9f, 0.5f, 0.1f, 1),
      gl.VertexAttrib3f(s.at("normalMC"), 0.2f, 0.6f, 0.9f);
  s.draw();
}

void translucentConstantColor(Gl gl) {
  Stage s{gl};
  s.begin();
  gl.DisableVertexAttribArray(s.at("scalarColor"));
  gl.VertexAttrib4f(s.at("scalarColor"), 0.9f, 0.5f, 0.1f, 0.5f);
  s.draw();
}

void arraysThatNobodyReads(Gl gl) {
  Stage s{gl};
  s.begin();
  s.fill(s.mesh.texcoords);
  gl.EnableVertexAttribArray(9), gl.VertexAttribPointer(9, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  s.draw();
}

void formatsAndBindings(Gl gl) {
  Stage s{gl};
  s.begin(0.001);
  const std::vector<InterleavedVertex> vertices = interleaved(s.mesh);
  const GLuint buffer = s.fill(vertices);
  gl.VertexAttribFormat(s.at("vertexMC"), 3, GL_SHORT, GL_FALSE, 0);
  gl.VertexAttribFormat(s.at("normalMC"), 3, GL_BYTE, GL_TRUE, 8);
  gl.VertexAttribFormat(s.at("scalarColor"), 4, GL_UNSIGNED_BYTE, GL_TRUE, 12);
  for (const char* name : {"vertexMC", "normalMC", "scalarColor"}) gl.VertexAttribBinding(s.at(name), 6);
  gl.BindVertexBuffer(6, buffer, 0, sizeof(InterleavedVertex));
  s.draw();
}

void formatsAndBindingsFromAnOffset(Gl gl) {
  Stage s{gl};
  s.begin(0.001);
  std::vector<InterleavedVertex> vertices = interleaved(s.mesh);
  vertices.insert(vertices.begin(), 5, InterleavedVertex{{9000, 9000, 9000, 1}, {}, {}});
  const GLuint buffer = s.fill(vertices);
  gl.VertexAttribFormat(s.at("vertexMC"), 3, GL_SHORT, GL_FALSE, 0),
      gl.VertexAttribBinding(s.at("vertexMC"), 7);
  gl.BindVertexBuffer(7, buffer, 5 * sizeof(InterleavedVertex), sizeof(InterleavedVertex));
  s.draw();
}

/// The same bytes as normalised and as plain numbers.
void normalizedAndNot(Gl gl) {
  Stage s{gl};
  s.begin();
  std::vector<GLubyte> colors;
  for (size_t i = 0; i < 3 * s.mesh.colors.size(); ++i) colors.push_back(i % 4 != 0);
  s.fill(colors);
  for (const GLboolean normalized : {GL_TRUE, GL_FALSE}) {
    gl.VertexAttribPointer(s.at("scalarColor"), 3, GL_UNSIGNED_BYTE, normalized, 0, nullptr);
    s.draw();
    gl.Finish();
    gl.Clear(normalized ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : 0);
  }
}

/// Every vertex the same: here a stride of 0 means that, not "packed".
void bindingWithoutStride(Gl gl) {
  Stage s{gl};
  s.begin();
  const GLuint buffer = s.fill(s.mesh.colors);
  gl.VertexAttribFormat(s.at("scalarColor"), 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
  gl.VertexAttribBinding(s.at("scalarColor"), 7);
  gl.BindVertexBuffer(7, buffer, 400, 0);
  s.draw();
}

void directStateAccess(Gl gl) {
  Stage s{gl};
  s.begin(0.001);
  std::vector<InterleavedVertex> vertices = interleaved(s.mesh);
  const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(InterleavedVertex));
  GLuint array = 0, buffers[2] = {};
  gl.CreateVertexArrays(1, &array), gl.CreateBuffers(2, buffers);
  gl.NamedBufferStorage(buffers[0], bytes, vertices.data(), GL_DYNAMIC_STORAGE_BIT);
  gl.NamedBufferData(buffers[1], static_cast<GLsizeiptr>(4 * s.mesh.indices.size()), s.mesh.indices.data(),
                     GL_STATIC_DRAW);
  const auto format = [&](const char* name, GLint size, GLenum type, GLboolean normalized, GLuint from) {
    gl.EnableVertexArrayAttrib(array, s.at(name));
    gl.VertexArrayAttribFormat(array, s.at(name), size, type, normalized, from);
    gl.VertexArrayAttribBinding(array, s.at(name), 1);
  };
  format("vertexMC", 3, GL_SHORT, GL_FALSE, 0), format("normalMC", 3, GL_BYTE, GL_TRUE, 8);
  format("scalarColor", 4, GL_UNSIGNED_BYTE, GL_TRUE, 12);
  gl.VertexArrayVertexBuffer(array, 1, buffers[0], 0, sizeof(InterleavedVertex));
  gl.VertexArrayElementBuffer(array, buffers[1]);
  gl.BindVertexArray(array);
  s.draw();
  gl.Finish();
  for (InterleavedVertex& v : vertices)
    v.position[0] = static_cast<GLshort>(v.position[0] / 2 + 900), v.color = {255, 255, 0, 255};
  gl.NamedBufferSubData(buffers[0], 0, bytes, vertices.data());
  s.draw();
}

struct ArrayCase {
  const char* name;
  DrawProgram draw;
  int traced = 1;
};
void PrintTo(const ArrayCase& c, std::ostream* out) { *out << c.name; }
const ArrayCase kArrayCases[] = {
    {"interleaved_shorts", interleavedShorts},
    {"doubles_and_three_bytes", doublesAndThreeBytes},
    {"normalized_and_not", normalizedAndNot, 2},
    {"positions_of_four", positionsOfFour},
    {"homogeneous", homogeneous, 0},
    {"flat_positions", flatPositions},
    {"constant_color_and_normal", constantColorAndNormal},
    {"translucent_constant_color", translucentConstantColor, 0},
    {"arrays_that_nobody_reads", arraysThatNobodyReads},
    {"formats_and_bindings", formatsAndBindings},
    {"formats_and_bindings_from_an_offset", formatsAndBindingsFromAnOffset},
    {"binding_without_stride", bindingWithoutStride, 0},
    {"direct_state_access", directStateAccess, 2},
};
class ProgramArrays : public testing::TestWithParam<ArrayCase> {};

TEST_P(ProgramArrays, LookLikeTheRealOnes) {
  expectBoth(GetParam().name, GetParam().draw, GetParam().traced, coreWish(4, 5));
}
INSTANTIATE_TEST_SUITE_P(Layouts, ProgramArrays, testing::ValuesIn(kArrayCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ProgramArrays, InMemoryOfTheProgramsOwn) {
  static const ProgramMesh mesh = ball(20);
  const Surface surface{.version = "#version 150 compatibility\n"};
  expectBoth(
      "own_memory",
      [&](Gl gl) {
        const GLuint program = makeProgram(gl, surface);
        upload(gl, mesh, program);
        gl.BindVertexArray(0), gl.BindBuffer(GL_ARRAY_BUFFER, 0), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        beginFrame(gl), gl.UseProgram(program);
        setAll(gl, program, perspectiveView(20), surface);
        const auto add = [&](const char* name, const std::vector<glm::vec3>& values) {
          const auto at = static_cast<GLuint>(gl.GetAttribLocation(program, name));
          gl.EnableVertexAttribArray(at), gl.VertexAttribPointer(at, 3, GL_FLOAT, GL_FALSE, 0, values.data());
        };
        add("vertexMC", mesh.positions), add("normalMC", mesh.normals);
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
      },
      0, {kProgramWidth, kProgramHeight});
}

}  // namespace
}  // namespace gluray::test
