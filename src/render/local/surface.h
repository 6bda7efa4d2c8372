// An instance in the form the kernels read. Made once a frame, read by every tracing thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "render/local/lighting.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

/// Where window depth of a plane comes from. With L the triangle's plane in object space (dot(L, p) = 0 on
/// it), the NDC depth at window position (x, y) is -dot(L, a + x*aX + y*aY) / dot(L, b), and the sign of
/// areaSign*dot(L, b) is that of the triangle's window-space area (positive: counterclockwise). Exact for
/// every invertible projection.
struct PlaneDepth {
  glm::dvec4 a{0}, aX{0}, aY{0}, b{0};
  double areaSign = 1;
};

/// What impostors need (scene/impostors.h). The pixel at window position (x, y) shows the points
/// start + x*startX + y*startY + k*step, homogeneous, of the lighting space, k growing away from the viewer.
struct ImpostorSpace {
  glm::dvec4 start{0}, startX{0}, startY{0}, step{0};
  glm::dvec4 clipZ{0}, clipW{0, 0, 0, 1};  // rows of the matrix from lighting space to clip space
};

struct Surface {
  const scene::Instance* instance = nullptr;
  const scene::Mesh* mesh = nullptr;
  const Lighting* lighting = nullptr;
  PlaneDepth depth;
  ImpostorSpace impostors;  // where the mesh is not of triangles
  glm::dmat4 clipFromObject{1};
  glm::mat4 eyeFromObject{1};
  glm::mat3 eyeFromObjectNormal{1};  // inverse transpose of the modelview's upper left 3x3
  float rescale = 1;  // GL_RESCALE_NORMAL: 1 / length of the third row of the inverse modelview
  bool cullsCcw = false, cullsCw = false;
  bool ownClipPlanes = false;  // planes that other instances do not share: tested at each hit
  bool frontIsCcw = true;
  // The instance's materials; where glColorMaterial follows a constant colour, copies that bear it.
  const scene::MaterialPair* materials = nullptr;
  uint32_t materialCount = 0;
  std::vector<scene::MaterialPair> coloredMaterials;
  bool colorsVary = false;  // the mesh has vertex colours

  /// True if neither culling nor the instance's own clip planes remove the point (primitive, u, v).
  bool accepts(uint32_t primitive, float u, float v) const;
  /// Weights of corners 1 and 2 where the plane of a triangle is seen at an NDC position; (0, 0) where it is
  /// not.
  glm::vec2 weightsAt(uint32_t primitive, const glm::dvec2& ndc) const;
  /// NDC depth of the point, from its corners.
  double ndcDepth(uint32_t primitive, float u, float v) const;
  /// Smallest and largest NDC depth of what the view volume leaves of the triangle.
  glm::dvec2 ndcDepths(uint32_t primitive) const;
  /// The centre, in lighting space, of an impostor about this point. Not inline: kernels would fuse the
  /// roundings that programs make.
  glm::vec3 centerOfImpostor(const glm::vec3& object) const;
  /// True if the triangle's window-space area is positive.
  bool isCcw(uint32_t primitive) const;
};

/// Material `m` with the components that `mode` names taken from `color`.
void applyColorMaterial(scene::ColorMaterial::Mode mode, const glm::vec4& color, scene::Material& m);

/// The camera, as far as every surface needs it.
struct View {
  WindowMap window;
  glm::dmat4 clipFromEye, eyeFromClip;
  double areaSign;  // -1 where the projection mirrors
  double away;      // 1 where normalised depth grows away from the viewer, otherwise -1
  explicit View(const scene::Camera&);
};

/// Throws std::runtime_error where the instance's modelview matrix cannot be inverted.
Surface makeSurface(const View&, const scene::Instance&, const Lighting&, bool sharedClipPlanes);

}  // namespace gluray::render
