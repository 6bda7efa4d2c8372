#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gluray::test {

GLuint makeProgram(Gl gl, const std::string& vertex, const std::string& fragment,
                   const std::string& geometry) {
  const GLuint program = gl.CreateProgram();
  const auto add = [&](GLenum kind, const std::string& text) {
    const GLuint shader = gl.CreateShader(kind);
    const char* start = text.c_str();
    gl.ShaderSource(shader, 1, &start, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
  };
  add(GL_VERTEX_SHADER, vertex), add(GL_FRAGMENT_SHADER, fragment);
  if (!geometry.empty()) add(GL_GEOMETRY_SHADER, geometry);
  for (GLuint i = 0; i < 3; ++i)
    gl.BindFragDataLocation(program, i, ("fragOutput" + std::to_string(i)).c_str());
  gl.LinkProgram(program);
  GLint linked = 0;
  std::array<char, 2000> log{};
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  EXPECT_TRUE(linked) << log.data() << vertex << fragment;
  return linked ? program : 0;
}

namespace {

uint32_t packed(const glm::vec3& c) {
  const glm::uvec3 u(glm::clamp(c, 0.0f, 1.0f) * 255.0f);
  return u.x | u.y << 8 | u.z << 16 | 0xff000000u;
}

void addSquares(ProgramMesh& mesh, GLuint n) {
  for (GLuint y = 0; y < n; ++y)
    for (GLuint x = 0; x < n; ++x) {
      const GLuint a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
}

}  // namespace

ProgramMesh sheet(int n) {
  ProgramMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const float u = 2 * static_cast<float>(x) / static_cast<float>(n) - 1,
                  v = 2 * static_cast<float>(y) / static_cast<float>(n) - 1;
      mesh.positions.emplace_back(u, v, 0.2f * std::sin(4 * u) * std::cos(3 * v));
      const float du = 0.8f * std::cos(4 * u) * std::cos(3 * v),
                  dv = -0.6f * std::sin(4 * u) * std::sin(3 * v);
      mesh.normals.push_back(glm::normalize(glm::vec3(-du, -dv, 1)));
      mesh.colors.push_back(packed({0.5f + 0.5f * u, 0.5f + 0.5f * v, 0.5f - 0.4f * u * v}));
      mesh.texcoords.emplace_back(0.5f + 0.45f * u, 0.5f + 0.45f * v);
    }
  addSquares(mesh, static_cast<GLuint>(n));
  return mesh;
}

ProgramMesh ball(int n) {
  ProgramMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(n),
                  v = static_cast<float>(y) / static_cast<float>(n);
      const float a = 6.2831853f * u, b = 3.1415927f * (v - 0.5f);
      const glm::vec3 p(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
      mesh.positions.push_back(p), mesh.normals.push_back(p);
      mesh.colors.push_back(packed(0.5f + 0.5f * p));
      mesh.texcoords.emplace_back(0.05f + 0.9f * u, 0.05f + 0.9f * v);
    }
  addSquares(mesh, static_cast<GLuint>(n));
  return mesh;
}

Upload upload(Gl gl, const ProgramMesh& mesh, GLuint program) {
  Upload up;
  gl.GenVertexArrays(1, &up.array);
  gl.BindVertexArray(up.array);
  const auto add = [&](const char* name, const auto& values, GLint size, GLenum type) {
    const GLint place = gl.GetAttribLocation(program, name);
    if (place < 0) return GLuint{0};
    const GLuint made = makeBuffer(gl, GL_ARRAY_BUFFER, values);
    gl.EnableVertexAttribArray(static_cast<GLuint>(place));
    gl.VertexAttribPointer(static_cast<GLuint>(place), size, type, type == GL_UNSIGNED_BYTE, 0, nullptr);
    return made;
  };
  up.positions = add("vertexMC", mesh.positions, 3, GL_FLOAT);
  up.normals = add("normalMC", mesh.normals, 3, GL_FLOAT);
  up.colors = add("scalarColor", mesh.colors, 4, GL_UNSIGNED_BYTE);
  up.texcoords = add("tcoord", mesh.texcoords, 2, GL_FLOAT);
  std::vector<glm::vec2> turned;  // a new position for each vertex
  for (const glm::vec2& at : mesh.texcoords) turned.emplace_back(at.y, 0.3f * at.x);
  add("colorTCoord", turned, 2, GL_FLOAT);
  std::vector<glm::vec3> tangents;  // not perpendicular to the normals, of different lengths
  for (const glm::vec3& n : mesh.normals)
    tangents.push_back(1.5f * glm::cross(glm::vec3(0.1f, 0.9f, 0.3f), n) + 0.2f * n);
  add("tangentMC", tangents, 3, GL_FLOAT);
  up.indices = makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
  return up;
}

namespace {

glm::dmat4 turned(double degrees) {
  const glm::dmat4 away = glm::translate(glm::dmat4(1), {0, 0, -4});
  return glm::rotate(away, glm::radians(degrees), glm::normalize(glm::dvec3(0.4, 1, 0.2)));
}

}  // namespace

View perspectiveView(double degrees) {
  return {turned(degrees), glm::perspective(glm::radians(40.0), 4.0 / 3, 1.0, 10.0)};
}
View parallelView(double degrees) { return {turned(degrees), glm::ortho(-2.0, 2.0, -1.5, 1.5, 1.0, 10.0)}; }

void setInteger(Gl gl, GLuint program, const char* name, int value) {
  gl.Uniform1i(gl.GetUniformLocation(program, name), value);
}
void setFloat(Gl gl, GLuint program, const char* name, float value) {
  gl.Uniform1f(gl.GetUniformLocation(program, name), value);
}
void setVec3(Gl gl, GLuint program, const char* name, const glm::vec3& value) {
  gl.Uniform3fv(gl.GetUniformLocation(program, name), 1, glm::value_ptr(value));
}
void setMat4(Gl gl, GLuint program, const char* name, const glm::mat4& value) {
  gl.UniformMatrix4fv(gl.GetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(value));
}
void setMat3(Gl gl, GLuint program, const char* name, const glm::mat3& value) {
  gl.UniformMatrix3fv(gl.GetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(value));
}

void setView(Gl gl, GLuint program, const View& view) {
  setMat4(gl, program, "MCDCMatrix", glm::mat4(view.clipFromEye * view.eyeFromObject));
  setMat4(gl, program, "MCVCMatrix", glm::mat4(view.eyeFromObject));
  setMat3(gl, program, "normalMatrix",
          glm::mat3(glm::transpose(glm::inverse(glm::dmat3(view.eyeFromObject)))));
  setInteger(gl, program, "cameraParallel", view.clipFromEye[3][3] != 0);
}

void setAll(Gl gl, GLuint program, const View& view, const Surface& surface) {
  setView(gl, program, view);
  const auto material = [&](const std::string& suffix, const glm::vec3& color, float shininess) {
    const auto number = [&](const char* name, float v) { setFloat(gl, program, (name + suffix).c_str(), v); };
    const auto vector = [&](const char* name, const glm::vec3& v) {
      setVec3(gl, program, (name + suffix).c_str(), v);
    };
    number("ambientIntensity", 0.2f), number("diffuseIntensity", 0.9f), number("specularIntensity", 0.4f);
    number("opacityUniform", 1), number("specularPowerUniform", shininess);
    vector("ambientColorUniform", glm::vec3(1, 0.8f, 0.6f)), vector("diffuseColorUniform", color);
    vector("specularColorUniform", glm::vec3(1, 1, 0.9f));
  };
  material("", {0.3f, 0.6f, 0.9f}, 20);
  if (surface.backMaterial) material("BF", {0.9f, 0.4f, 0.1f}, 5);
  const glm::vec3 ways[] = {{0.1f, 0.3f, -0.95f},
                            {-0.7f, 0.1f, -0.7f},
                            {0.6f, -0.6f, -0.5f},
                            {0.0f, -0.8f, -0.6f},
                            {0.2f, 0.2f, 0.9f}};
  for (int i = 0; i < surface.lightCount; ++i) {
    const std::string n = std::to_string(i);
    const float f = static_cast<float>(i);
    setVec3(gl, program, ("lightColor" + n).c_str(), glm::vec3(0.8f, 0.7f - 0.1f * f, 0.6f) / (1 + 0.7f * f));
    setVec3(gl, program, ("lightDirectionVC" + n).c_str(), glm::normalize(ways[i]));
    setVec3(gl, program, ("lightPositionVC" + n).c_str(), {0.5f - f, 0.8f, -1.5f});
    setVec3(gl, program, ("lightAttenuation" + n).c_str(), {0.5f, 0.1f, 0.05f});
    setFloat(gl, program, ("lightConeAngle" + n).c_str(), i == 1 ? 25.0f : 180.0f);
    setFloat(gl, program, ("lightExponent" + n).c_str(), 2);
    setInteger(gl, program, ("lightPositional" + n).c_str(), i != 2);
  }
  setFloat(gl, program, "metallicUniform", 0.4f), setFloat(gl, program, "roughnessUniform", 0.35f);
  setFloat(gl, program, "aoStrengthUniform", 1), setFloat(gl, program, "baseF0Uniform", 0.04f);
  setVec3(gl, program, "edgeTintUniform", {1, 0.9f, 0.8f});
  if (surface.edges) setEdges(gl, program);
}

namespace {

void bufferTexture(Gl gl, GLenum unit, GLenum format, GLsizeiptr bytes, const void* texels) {
  GLuint names[2] = {};
  gl.GenBuffers(1, &names[0]), gl.GenTextures(1, &names[1]);
  gl.BindBuffer(GL_TEXTURE_BUFFER, names[0]);
  gl.BufferData(GL_TEXTURE_BUFFER, bytes, texels, GL_STATIC_DRAW);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(GL_TEXTURE_BUFFER, names[1]);
  gl.TexBuffer(GL_TEXTURE_BUFFER, format, names[0]);
}

void makeTexture(Gl gl, GLenum unit, int width, int height, GLenum format, const void* texels, GLint filter) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, format, GL_UNSIGNED_BYTE,
                texels);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, what, filter);
  for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, what, GL_CLAMP_TO_EDGE);
}

}  // namespace

void cellColors(Gl gl, const ProgramMesh& mesh, GLenum unit, size_t before) {
  std::vector<uint32_t> texels(before, 0xff0000ffu);
  for (size_t i = 0; i < mesh.triangles(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(mesh.triangles());
    texels.push_back(packed({t, 0.3f + 0.5f * static_cast<float>(i % 3) / 3, 1 - t}));
  }
  bufferTexture(gl, unit, GL_RGBA8, static_cast<GLsizeiptr>(4 * texels.size()), texels.data());
}

void cellNormals(Gl gl, const ProgramMesh& mesh, GLenum unit, size_t before) {
  std::vector<glm::vec4> texels(before, glm::vec4(1, 0, 0, 0));
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto p = [&](size_t k) { return mesh.positions[mesh.indices[i + k]]; };
    const glm::vec3 n = glm::cross(p(1) - p(0), p(2) - p(0));
    texels.emplace_back(glm::length(n) > 0 ? glm::normalize(n) : glm::vec3(0, 0, 1), 0.0f);
  }
  bufferTexture(gl, unit, GL_RGBA32F, static_cast<GLsizeiptr>(16 * texels.size()), texels.data());
}

void colorMap(Gl gl, GLenum unit) {
  std::vector<uint32_t> texels;
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 10; ++i) {
      const float t = static_cast<float>(i) / 9;
      texels.push_back(row ? 0xff00ffffu : packed({t, 0.4f, 1 - t}));
    }
  makeTexture(gl, unit, 10, 2, GL_RGBA, texels.data(), GL_NEAREST);
}

void chequers(Gl gl, GLenum unit) {
  std::vector<uint8_t> texels;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c)
        texels.push_back((x + y) % 2 ? 250 : static_cast<uint8_t>(90 + 10 * x * (c == 1)));
  makeTexture(gl, unit, 8, 8, GL_RGB, texels.data(), GL_LINEAR);
}

void beginFrame(Gl gl) {
  gl.Viewport(0, 0, kProgramWidth, kProgramHeight);
  gl.ClearColor(0.2f, 0.3f, 0.4f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LEQUAL);
  gl.Enable(GL_BLEND);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void drawSurface(Gl gl, GLuint program, const Upload& up, const ProgramMesh& mesh, const View& view,
                 const Surface& surface) {
  gl.UseProgram(program);
  setAll(gl, program, view, surface);
  gl.BindVertexArray(up.array);
  gl.DrawRangeElements(GL_TRIANGLES, 0, static_cast<GLuint>(mesh.positions.size() - 1), mesh.count(),
                       GL_UNSIGNED_INT, nullptr);
}

GLuint makeUnknownProgram(Gl gl) {
  return makeProgram(gl,
                     "#version 150\nin vec4 vertexMC;\nuniform mat4 MCDCMatrix;\n"
                     "void main()\n{\n  gl_Position = MCDCMatrix * vertexMC;\n}\n",
                     "#version 150\nout vec4 color;\nvoid main()\n{\n"
                     "  color = vec4(fract(gl_FragCoord.xy / 37.0), 0.2, 1.0);\n}\n");
}

void drawByUnknown(Gl gl, GLuint program, const Upload& up, const ProgramMesh& mesh, const View& view) {
  gl.UseProgram(program);
  setMat4(gl, program, "MCDCMatrix", glm::mat4(view.clipFromEye * view.eyeFromObject));
  gl.BindVertexArray(up.array);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

}  // namespace gluray::test
