// An instance, prepared for the kernels. Made once per frame, read by every tracing thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "render/local/lighting.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

/// Coefficients for the window depth of a triangle's plane L in object space (dot(L, p) = 0 on it). The NDC
/// depth at window position (x, y) is -dot(L, a + x*aX + y*aY) / dot(L, b); areaSign*dot(L, b) has the sign
/// of the triangle's window-space area (positive: counterclockwise). Exact for every invertible projection.
struct PlaneDepth {
  glm::dvec4 a{0}, aX{0}, aY{0}, b{0};
  double areaSign = 1;
};

/// Lines of sight for impostors (scene/impostors.h), in lighting space. The pixel at window position (x, y)
/// shows the homogeneous points start + x*startX + y*startY + k*step; k grows away from the viewer.
struct ImpostorSpace {
  glm::dvec4 start{0}, startX{0}, startY{0}, step{0};
  glm::dvec4 clipZ{0}, clipW{0, 0, 0, 1};  // rows of the matrix from lighting space to clip space
};

struct Surface {
  const scene::Instance* instance = nullptr;
  const scene::Mesh* mesh = nullptr;
  const Lighting* lighting = nullptr;
  PlaneDepth depth;
  ImpostorSpace impostors;  // unless the mesh's shape is triangles
  glm::dmat4 clipFromObject{1};
  glm::mat4 eyeFromObject{1};
  glm::mat3 eyeFromObjectNormal{1};  // inverse transpose of the modelview's upper left 3x3
  glm::mat3 eyeFromVertexNormal{1};  // for the mesh's normals, as the program turns them
  float rescale = 1;  // GL_RESCALE_NORMAL: 1 / length of the third row of the inverse modelview
  bool cullsCcw = false, cullsCw = false;
  bool ownClipPlanes = false;  // clip planes that not all instances share: tested at each hit
  bool frontIsCcw = true;
  // The instance's materials; if glColorMaterial follows a constant colour, copies with that colour.
  const scene::MaterialPair* materials = nullptr;
  uint32_t materialCount = 0;
  std::vector<scene::MaterialPair> coloredMaterials;
  bool colorsVary = false;  // the mesh has vertex colours

  /// True if neither culling nor the instance's own clip planes remove the point (primitive, u, v).
  bool accepts(uint32_t primitive, float u, float v) const { return acceptsFrom(depth.b, primitive, u, v); }
  /// Like accepts(), for a homogeneous viewpoint in object space; depth.b is the camera.
  bool acceptsFrom(const glm::dvec4& viewer, uint32_t primitive, float u, float v) const;
  /// Whether the instance's own clip planes remove the point.
  bool isCutAway(uint32_t primitive, float u, float v) const;
  /// Weights of corners 1 and 2 at the point of a triangle's plane at an NDC position; (0, 0) if there is
  /// none.
  glm::vec2 weightsAt(uint32_t primitive, const glm::dvec2& ndc) const;
  /// NDC depth of the point, from its corners.
  double ndcDepth(uint32_t primitive, float u, float v) const;
  /// Smallest and largest NDC depth of the triangle, clipped to the view volume.
  glm::dvec2 ndcDepths(uint32_t primitive) const;
  /// The centre, in lighting space, of an impostor at this point. Not inline: in the kernels, fused
  /// multiply-adds would round differently from the programs.
  glm::vec3 centerOfImpostor(const glm::vec3& object) const;
  /// True if the triangle's window-space area is positive.
  bool isCcw(uint32_t primitive) const { return isCcwFrom(depth.b, primitive); }
  bool isCcwFrom(const glm::dvec4& viewer, uint32_t primitive) const;
};

/// Replaces the components of material `m` that `mode` names by `color`.
void applyColorMaterial(scene::ColorMaterial::Mode mode, const glm::vec4& color, scene::Material& m);

/// Values derived from the camera, common to all surfaces.
struct View {
  WindowMap window;
  glm::dmat4 clipFromEye, eyeFromClip;
  double areaSign;  // -1 if the projection mirrors, otherwise 1
  double away;      // 1 if NDC depth grows away from the viewer, otherwise -1
  explicit View(const scene::Camera&);
};

/// Throws std::runtime_error if the instance's modelview matrix cannot be inverted.
Surface makeSurface(const View&, const scene::Instance&, const Lighting&, bool sharedClipPlanes);

}  // namespace gluray::render
