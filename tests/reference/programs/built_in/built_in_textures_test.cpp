// Textures of programs that take their coordinates and matrix from fixed function.
#include "tests/reference/programs/built_in/built_in_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

struct BuiltInTexture {
  const char* name;
  GLint minFilter, wrap;
  bool matrix = false;
  bool coordinates = true;  // of the vertices; otherwise the current one
};
void PrintTo(const BuiltInTexture& c, std::ostream* out) { *out << c.name; }

const BuiltInTexture kBuiltInTextures[] = {
    {"nearest", GL_NEAREST, GL_CLAMP_TO_EDGE},         {"repeated", GL_LINEAR, GL_REPEAT},
    {"mipmapped", GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT}, {"moved", GL_LINEAR, GL_MIRRORED_REPEAT, true},
    {"constant", GL_LINEAR, GL_REPEAT, false, false},
};

/// An image of 32 x 32 soft waves, with mipmaps.
void waves(Gl gl, const BuiltInTexture& c) {
  std::vector<GLubyte> texels;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      for (const int v : {8 * x, 8 * y, 255 - 4 * (x + y), 255}) texels.push_back(static_cast<GLubyte>(v));
  GLuint name = 0;
  gl.GenTextures(1, &name), gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, c.minFilter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, c.wrap);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, c.wrap);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

class BuiltInTextures : public testing::TestWithParam<BuiltInTexture> {};

TEST_P(BuiltInTextures, MultiplyColorsBeforeTheyAreLit) {
  const BuiltInTexture& c = GetParam();
  for (const Way way : {Way::clientElements, Way::clientArrays, Way::buffers, Way::list})
    expectBuiltIns(
        std::string("texture-") + c.name + "-" + nameOf(way),
        [&](Gl gl) {
          const GLuint program = makeProgram(gl, kOpenCtm.vertex, kOpenCtm.fragment);
          ProgramMesh wavy = sheet(16);
          wavy.texcoords.clear();
          for (const glm::vec3& p : wavy.positions)
            if (c.coordinates) wavy.texcoords.emplace_back(1.3f * p.x + 0.4f, 0.8f * p.y - 0.2f);
          beginBuiltInFrame(gl);
          waves(gl, c);
          gl.UseProgram(program);
          setInteger(gl, program, "uUseTexture", 1);
          gl.TexCoord2f(0.3f, 0.7f);
          if (c.matrix) {
            const glm::mat4 moved = glm::rotate(glm::scale(glm::mat4(1), {1.5f, 0.7f, 1}), 0.5f, {0, 0, 1});
            gl.MatrixMode(GL_TEXTURE), gl.LoadMatrixf(glm::value_ptr(moved)), gl.MatrixMode(GL_MODELVIEW);
          }
          sendMesh(gl, wavy, way);
          setInteger(gl, program, "uUseTexture", 0);
          gl.Translatef(0, 0, 0.5f), gl.Scalef(0.4f, 0.4f, 0.4f);
          sendMesh(gl, wavy, way);
        },
        2);
}

INSTANTIATE_TEST_SUITE_P(Cases, BuiltInTextures, testing::ValuesIn(kBuiltInTextures),
                         [](const auto& info) { return std::string(info.param.name); });

/// The program takes s and t as they are, fixed function's textures divide them by q.
TEST(BuiltInTexture, WithAQIsLeft) {
  for (const Way way : {Way::clientElements, Way::list})
    expectBuiltIns(
        "texture-q-" + nameOf(way),
        [&](Gl gl) {
          const GLuint program = makeProgram(gl, kOpenCtm.vertex, kOpenCtm.fragment);
          ProgramMesh wavy = sheet(8);
          wavy.texcoords.clear();
          beginBuiltInFrame(gl);
          waves(gl, kBuiltInTextures[1]);
          gl.UseProgram(program);
          setInteger(gl, program, "uUseTexture", 1);
          gl.TexCoord4f(0.5f, 0.3f, 0, 2), sendMesh(gl, wavy, way);
          gl.TexCoord4f(0.5f, 0.3f, 7, 1), gl.Translatef(0, 0, 0.4f), sendMesh(gl, wavy, way);
        },
        1);
}

}  // namespace
}  // namespace gluray::test
