// The inputs of the current shader program, read from the real OpenGL when a draw needs them. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/basics/reasons.h"
#include "gl/program_state/pulled_vertices.h"
#include "gl/programs/match.h"
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

/// The current shader program's uniforms and textures, translated into the scene's terms.
struct ProgramState {
  std::shared_ptr<const KnownProgram> known;  // null: not read
  UniformValuesPtr uniforms;                  // current values of all uniforms
  Reason reason = Reason::program;            // why its surfaces cannot be traced, or Reason::traced
  std::string why;                            // details of `reason` for the user; may be empty
  glm::dmat4 clipFromObject{1};               // to depths from -1 to 1, whatever glClipControl says
  std::optional<glm::dmat4> eyeFromObject;    // if the program has one
  glm::mat3 normalMatrix{1};
  scene::Shading shading;
  scene::MaterialPair material;
  std::vector<glm::dvec4> clipPlanes;   // object space
  std::optional<scene::Region> window;  // of pixels that the program draws
  scene::PolygonOffset depthOffset;
  scene::Impostors impostors;
  float pixelSize = 0;        // of points and lines that the program sizes in pixels; 0: not given
  float lineSize = 0;         // width of lines in normalised device coordinates, along x; 0: not given
  glm::vec4 usedViewport{0};  // that the program computes tubes with, if it does so in pixels
  float impostorRadius = 1;   // if no array provides radii
  float impostorCaps = 0;
  scene::Attribute triangleColors, triangleNormals, triangleEdges;
  uint32_t triangleColorCount = 0, triangleNormalCount = 0, triangleEdgeCount = 0, triangleOffset = 0;
  bool opaqueTriangleColors = true;
  std::optional<PulledVertices> pulled;  // if the family pulls its vertices
  bool hidesBackFaces = false;           // back faces have an alpha of 0 and are discarded
  bool instanceColors = false;           // each instance has its own colour
  bool overridden = false;               // the material's colours replace all others (Family::uniformColors)
  glm::vec4 color{1};                    // if the colour attribute is not an array
  glm::vec3 normal{0, 0, 1};
  glm::vec4 texcoord{0, 0, 0, 1}, texcoordAbove{0, 0, 0, 1};  // texcoordAbove: if hasTwoTexcoords()
  glm::vec3 tangent{0};                                       // if the tangent attribute is not an array
};

/// Whether the program takes its vertices from fixed function's attributes.
inline bool readsBuiltIns(const ProgramState& program) {
  return program.known && program.known->family && program.known->family->hasBuiltInVertices();
}

/// The reason against tracing that holds in any state: no family describes the program. Reason::traced if one
/// does.
inline Reason reasonWithoutFamily(const KnownProgram& known) {
  if (known.family) return Reason::traced;
  return known.unknownCode ? Reason::programCode : Reason::program;
}

/// Whether a colour of the mesh has a channel below 0. `color`: that of a mesh without colours.
bool hasNegativeColors(const scene::Mesh& mesh, const glm::vec4& color);

/// Whether the material's colours replace those of the vertices, but not their opacity, which is below 1. No
/// shading has both. `color`: colour of a mesh without colours.
bool showsOpacityBeneath(const ProgramState& program, const scene::Mesh& mesh, const glm::vec4& color);
/// Whether all alphas of the program's surface of this mesh are at least 1. `color`: colour of a mesh without
/// colours.
bool drawsOpaque(const ProgramState& program, const scene::Mesh& mesh, const glm::vec4& color);

/// The fixed-function state that keeps draws with gl_FrontColor from being traced, for the user; empty if
/// there is none. Not for core profiles.
std::string builtInColorObstacle(const RealGl& real, const Family& family);

/// Name of the attribute that holds the colour map's texture coordinates.
const std::string& mapTexcoord(const Program& program, const Family& family);
/// Whether colour map and textures use different attributes: the map then uses texture coordinates 0, and the
/// textures use 1.
bool hasTwoTexcoords(const Program& program, const Family& family);

/// Reads program `known` into `state`. `textures` provides texture images. `solids`: settings turn lines or
/// points into solids.
void readProgram(const RealGl& real, ShareGroup& group, const RareState& has, TextureCache& textures,
                 ProgramState& state, bool solids);

/// Reads the vertex arrays that the shader program's family names. All other enabled arrays go to
/// ArrayState::generic. `program`: null if its family is unknown.
void readAttributes(const RealGl& real, ShareGroup& group, const KnownProgram* program, ArrayState& arrays);

}  // namespace gluray::gl
