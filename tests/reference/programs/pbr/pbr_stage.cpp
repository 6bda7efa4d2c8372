#include "tests/reference/programs/pbr/pbr_stage.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

namespace gluray::test {
namespace {

constexpr int kSide = 32;
constexpr int kCubeSide = 16, kCubeLevels = 5;

uint8_t byteOf(float v) { return static_cast<uint8_t>(std::lround(glm::clamp(v, 0.0f, 1.0f) * 255)); }

void useUnit(Gl gl, GLuint program, const char* sampler, GLenum target, GLenum unit) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(target, name);
  setInteger(gl, program, sampler, static_cast<int>(unit));
}

/// A repeated image of kSide x kSide texels, and its smaller levels. color(s, t): of the place in 0 .. 1.
template <class Color>
void material(Gl gl, GLuint program, const char* sampler, GLenum unit, GLint format, const PbrFilter& filter,
              Color&& color) {
  std::vector<uint8_t> texels;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec4 c =
          color((static_cast<float>(x) + 0.5f) / kSide, (static_cast<float>(y) + 0.5f) / kSide);
      for (int i = 0; i < 4; ++i) texels.push_back(byteOf(c[i]));
    }
  useUnit(gl, program, sampler, GL_TEXTURE_2D, unit);
  gl.TexImage2D(GL_TEXTURE_2D, 0, format, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  if (filter.smallest != GL_LINEAR) gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter.smallest);
  gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, filter.anisotropy);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void setMaterial(Gl gl, GLuint program, const Surface& surface, const PbrFilter& filter) {
  if (surface.pbrTextures) {
    material(gl, program, "albedoTex", 5, GL_SRGB8_ALPHA8, filter, [](float s, float t) {
      return glm::vec4(0.5f + 0.4f * std::sin(12.6f * s), 0.6f + 0.3f * std::cos(6.3f * t), 0.7f, 1);
    });
    material(gl, program, "materialTex", 6, GL_RGBA8, filter, [](float s, float t) {
      return glm::vec4(0.6f + 0.4f * std::cos(12.6f * t), 0.5f + 0.4f * std::sin(6.3f * s), t, 1);
    });
    material(gl, program, "emissiveTex", 7, GL_SRGB8_ALPHA8, filter, [](float s, float t) {
      return glm::vec4(s > 0.7f ? 0.5f : 0.1f, 0.2f + 0.2f * std::sin(12.6f * t), 0.1f, 1);
    });
    setVec3(gl, program, "emissiveFactorUniform", {1, 0.8f, 0.5f});
    setFloat(gl, program, "aoStrengthUniform", 0.7f);
  }
  if (!surface.normalMap) return;
  material(gl, program, "normalTex", 8, filter.normals, filter, [](float s, float t) {
    return glm::vec4(0.5f + 0.15f * std::sin(12.6f * s), 0.5f + 0.15f * std::cos(12.6f * t), 0.95f, 1);
  });
  setFloat(gl, program, "normalScaleUniform", 0.8f);
}

/// Light of a sky, above 1 towards a sun, that differs between the levels of a cube map.
glm::vec3 skyLight(const glm::vec3& direction, int level) {
  const glm::vec3 d = glm::normalize(direction);
  const float sun = std::pow(std::max(glm::dot(d, glm::normalize(glm::vec3(0.3f, 0.5f, 0.8f))), 0.0f),
                             static_cast<float>(16 >> level));
  return glm::vec3(0.3f, 0.4f, 0.5f) + 0.2f * d + 1.5f * sun * glm::vec3(1, 0.9f, 0.7f) +
         0.1f * static_cast<float>(level);
}

/// The direction of a point in a face, s and t in -1 .. 1 (OpenGL 4.6, table 8.19).
glm::vec3 directionIn(int face, float s, float t) {
  const std::array<glm::vec3, 6> directions = {glm::vec3(1, -t, -s), glm::vec3(-1, -t, s),
                                               glm::vec3(s, 1, t),   glm::vec3(s, -1, -t),
                                               glm::vec3(s, -t, 1),  glm::vec3(-s, -t, -1)};
  return directions[static_cast<size_t>(face)];
}

void cube(Gl gl, GLuint program, const char* sampler, GLenum unit, int levels) {
  useUnit(gl, program, sampler, GL_TEXTURE_CUBE_MAP, unit);
  for (int level = 0; level < levels; ++level) {
    const int side = kCubeSide >> level;
    for (int face = 0; face < 6; ++face) {
      std::vector<glm::vec3> texels;
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const auto at = [&](int i) {
            return (2 * static_cast<float>(i) + 1) / static_cast<float>(side) - 1;
          };
          // Texels differ strongly, so that filters across edges show.
          const float odd = (x + y + face) % 2 ? 0.2f : 0.0f;
          texels.push_back(skyLight(directionIn(face, at(x), at(y)), level) + odd);
        }
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level, GL_RGB16F, side, side,
                    0, GL_RGB, GL_FLOAT, texels.data());
    }
  }
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, levels - 1);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER,
                   levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, what, GL_CLAMP_TO_EDGE);
}

void brdfTable(Gl gl, GLuint program, GLenum unit) {
  std::vector<glm::vec2> texels;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float cosine = static_cast<float>(x) / kSide, roughness = static_cast<float>(y) / kSide;
      texels.emplace_back(0.9f - 0.4f * roughness + 0.1f * cosine, 0.3f * (1 - cosine) * (1 - roughness));
    }
  useUnit(gl, program, "brdfTex", GL_TEXTURE_2D, unit);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, kSide, kSide, 0, GL_RG, GL_FLOAT, texels.data());
  for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, what, GL_LINEAR);
  for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, what, GL_CLAMP_TO_EDGE);
}

void setEnvironment(Gl gl, GLuint program, const Surface& surface) {
  if (surface.environment == Surface::Environment::none) return;
  gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  cube(gl, program, "prefilterTex", 9, kCubeLevels);
  brdfTable(gl, program, 10);
  if (surface.environment == Surface::Environment::cube) cube(gl, program, "irradianceTex", 11, 1);
  const float coefficients[][9] = {{0.6f, 0.2f, 0.3f, -0.1f, 0.1f, 0.2f, -0.1f, 0.05f, 0.1f},
                                   {0.5f, 0.3f, 0.1f, 0.1f, -0.1f, 0.1f, 0.05f, 0.1f, -0.05f},
                                   {0.4f, -0.2f, 0.2f, 0.2f, 0.05f, -0.1f, 0.1f, 0.2f, 0.1f}};
  const char* const names[] = {"shRed", "shGreen", "shBlue"};
  for (int c = 0; c < 3; ++c) gl.Uniform1fv(gl.GetUniformLocation(program, names[c]), 9, coefficients[c]);
  const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(0.2f, 1, -0.3f)));
  setMat3(gl, program, "envMatrix", glm::mat3(turned));
  setFloat(gl, program, "IBLIntensity", 0.6f);
}

}  // namespace

void setPbrInputs(Gl gl, GLuint program, const Surface& surface, const PbrFilter& filter) {
  setMaterial(gl, program, surface, filter);
  setEnvironment(gl, program, surface);
}

}  // namespace gluray::test
