// A draw's fixed-function shading state: lighting (GL 2.1, section 2.14), fog, alpha test, textures. Plain
// data.
#pragma once
#include "scene/fragment_shading.h"
#include "scene/texture.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace gluray::scene {

/// One enabled light, in the eye space of the time it was set.
struct Light {
  glm::vec4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1};
  glm::vec4 position{0, 0, 1, 0};     // eye space; w = 0: directional
  glm::vec3 spotDirection{0, 0, -1};  // eye space, not normalised
  float spotExponent = 0;             // 0 .. 128
  float spotCutoff = 180;             // degrees: 0 .. 90, or 180 for no spot
  glm::vec3 attenuation{1, 0, 0};     // constant, linear, quadratic
  bool operator==(const Light&) const = default;
};

struct Material {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1}, diffuse{0.8f, 0.8f, 0.8f, 1}, specular{0, 0, 0, 1},
      emission{0, 0, 0, 1};
  float shininess = 0;  // 0 .. 128
  bool operator==(const Material&) const = default;
};

/// Materials of front and back faces.
struct MaterialPair {
  Material front, back;
  bool operator==(const MaterialPair&) const = default;
};

/// Which material colour follows the vertex colour (glColorMaterial with GL_COLOR_MATERIAL enabled).
struct ColorMaterial {
  enum Mode : uint8_t { off, emission, ambient, diffuse, specular, ambientAndDiffuse };
  Mode front = off, back = off;
  bool operator==(const ColorMaterial&) const = default;
};

/// GL_FOG (GL 2.1, 3.10): the fragment's colour fades into `color` with |z| in eye space. Fog of shader
/// programs: with -z in their eye space; colours are not clamped.
struct Fog {
  enum Mode : uint8_t { off, linear, exp, exp2 };
  Mode mode = off;
  float density = 1;         // exp, exp2
  float start = 0, end = 1;  // linear
  glm::vec3 color{0};
  bool clampsSum = true;  // the sum of primary and secondary colour is clamped before fog (GL 2.1, 3.9)
  bool fromCoordinates = false;  // GL_FOG_COORD: uses fog coordinates instead of the distance
  bool scaled = false;           // linear: `scale` replaces 1 / (end - start)
  float scale = 0;
  bool extrapolates = false;  // linear: the colour's weight may be below 0, beyond `end`
  bool operator==(const Fog&) const = default;
};

/// GL_ALPHA_TEST: discards fragments whose alpha fails the comparison with `reference` (GL 2.1, 4.1.4). Both
/// are compared in the framebuffer's precision.
struct AlphaTest {
  enum Function : uint8_t { always, never, less, lessOrEqual, equal, greaterOrEqual, greater, notEqual };
  Function function = always;
  bool asBytes = false;  // precision: 8 bits; otherwise float
  float reference = 0;   // 0 .. 1
  bool operator==(const AlphaTest&) const = default;
};

/// Shading state of one draw. Instances of equal state share one.
struct Shading {
  bool lighting = false;  // off: the vertex colour is the fragment's primary colour
  bool smooth = true;     // GL_SMOOTH; otherwise the provoking vertex's colour
  bool twoSided = false;  // back faces: back material, reversed normal
  bool localViewer = false;
  bool separateSpecular = false;  // specular is added after texturing
  bool colorSum = false;       // GL_COLOR_SUM without lighting: the secondary colour is added after texturing
  bool normalize = false;      // GL_NORMALIZE
  bool rescaleNormal = false;  // GL_RESCALE_NORMAL
  ColorMaterial colorMaterial;
  glm::vec4 globalAmbient{0.2f, 0.2f, 0.2f, 1};
  std::vector<Light> lights;
  std::vector<Texture> textures;  // of the enabled texture units, in the order they are applied
  Fog fog;
  AlphaTest alphaTest;
  FragmentShading
      fragment;  // of shader programs; where it is on, only textures, fog and alphaTest of the above apply
  bool operator==(const Shading&) const = default;
};

/// Whether a shader program shades it instead of fixed function.
inline bool isProgram(const Shading& s) { return s.fragment.model != FragmentShading::Model::off; }
/// Whether lights act on it.
inline bool isLit(const Shading& s) {
  return isProgram(s) ? s.fragment.model != FragmentShading::Model::unlit : s.lighting;
}

}  // namespace gluray::scene
