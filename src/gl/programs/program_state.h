// What the current shader program draws with, read from the real OpenGL when a draw needs it. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/draws/reasons.h"
#include "gl/families/match.h"
#include "gl/programs/uniforms.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>

namespace gluray::gl {

class ShareGroup;
class TextureCache;
struct RareState;

/// Values of the current program's uniforms and textures in the terms of the scene.
struct ProgramState {
  std::shared_ptr<const KnownProgram> known;  // null: not read
  UniformValuesPtr uniforms;                  // all of them, of now
  Reason reason = Reason::program;            // why its surfaces cannot be traced, or Reason::traced
  std::string why;                            // the same in the program's own words, where there are such
  glm::dmat4 clipFromObject{1};
  std::optional<glm::dmat4> eyeFromObject;  // where the program has one
  glm::mat3 normalMatrix{1};
  scene::Shading shading;
  scene::MaterialPair material;
  std::vector<glm::dvec4> clipPlanes;  // object space
  scene::PolygonOffset depthOffset;
  scene::Impostors impostors;
  float impostorRadius = 1;  // where no array gives it
  scene::Attribute triangleColors, triangleNormals, triangleEdges;
  uint32_t triangleColorCount = 0, triangleNormalCount = 0, triangleEdgeCount = 0, triangleOffset = 0;
  bool opaqueTriangleColors = true;
  bool instanceColors = false;  // each instance brings its own
  bool overridden = false;      // the material's colours stand in for others
  glm::vec4 color{1};           // of programs whose colour attribute is not an array
  glm::vec3 normal{0, 0, 1};
  glm::vec4 texcoord{0, 0, 0, 1}, texcoordAbove{0, 0, 0, 1};  // the latter of hasTwoTexcoords()
};

/// The attribute where the colour map is looked up.
const std::string& mapTexcoord(const Program& program, const Family& family);
/// Whether colour map and textures are looked up at different attributes: then the map's are coordinates 0,
/// and the textures' coordinates 1.
bool hasTwoTexcoords(const Program& program, const Family& family);

/// Reads program `known` into `state`. Textures are looked up in `textures`.
void readProgram(const RealGl& real, ShareGroup& group, const RareState& has, TextureCache& textures,
                 ProgramState& state);

/// The vertex arrays of a program as far as its family names them; all others that are on as
/// ArrayState::generic. `program`: null where its family is unknown.
void readAttributes(const RealGl& real, ShareGroup& group, const KnownProgram* program, ArrayState& arrays);

}  // namespace gluray::gl
