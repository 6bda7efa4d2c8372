// Views of a volume in a box, for the tests of render/volumes.
#pragma once
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <utility>
#include <vector>

namespace gluray::test {

/// A viewer of a box in data space.
struct VolumeCamera {
  glm::dvec3 eye{0, 0, 4}, target{0}, up{0.1, 1, 0.05};
  bool parallel = false;
  double height = 0.8;  // of the image: tangent of the angle, or data space if parallel
  double near = 0.1, far = 20;
  glm::ivec2 pixels{24, 20};
};

struct VolumeBox {
  glm::dvec3 lower{-1}, upper{1};  // data space
  glm::ivec3 voxels{1};
};

inline glm::dmat4 windowFromData(const VolumeCamera& camera) {
  const double aspect = static_cast<double>(camera.pixels.x) / camera.pixels.y;
  const double half = camera.height / 2 * (camera.parallel ? 1 : camera.near);
  const glm::dmat4 clipFromEye =
      camera.parallel ? glm::ortho(-half * aspect, half * aspect, -half, half, camera.near, camera.far)
                      : glm::frustum(-half * aspect, half * aspect, -half, half, camera.near, camera.far);
  const glm::dmat4 eyeFromData = glm::lookAt(camera.eye, camera.target, camera.up);
  const glm::dvec3 window(camera.pixels, 1);
  return glm::scale(glm::dmat4(1), window * 0.5) * glm::translate(glm::dmat4(1), glm::dvec3(1)) *
         clipFromEye * eyeFromData;
}

/// The voxels at the box's faces have their centres there.
inline glm::dmat4 textureFromData(const VolumeBox& box) {
  const glm::dvec3 voxels(box.voxels), scale = (voxels - 1.0) / voxels / (box.upper - box.lower);
  // A box of one voxel has any width.
  const glm::dvec3 some =
      glm::mix(scale, 1e-3 / (box.upper - box.lower), glm::equal(box.voxels, glm::ivec3(1)));
  return glm::translate(glm::dmat4(1), 0.5 / voxels) * glm::scale(glm::dmat4(1), some) *
         glm::translate(glm::dmat4(1), -box.lower);
}

/// Both triangles of the box's face at the lower or upper end of an axis.
inline std::array<glm::dvec3, 6> boxFace(const VolumeBox& box, int axis, bool upper) {
  const auto at = [&](bool u, bool v) {
    glm::dvec3 p = box.lower;
    if (upper) p[axis] = box.upper[axis];
    if (u) p[(axis + 1) % 3] = box.upper[(axis + 1) % 3];
    if (v) p[(axis + 2) % 3] = box.upper[(axis + 2) % 3];
    return p;
  };
  return {at(false, false), at(true, false), at(true, true),
          at(false, false), at(true, true),  at(false, true)};
}

/// The faces of a box that a viewer outside of it sees.
inline void addFrontFaces(const VolumeBox& box, scene::VolumeView& view) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const double side = upper ? 1 : -1;
      const double away = view.direction != glm::dvec3(0)
                              ? -view.direction[axis] * side
                              : (view.viewer[axis] - (upper ? box.upper : box.lower)[axis]) * side;
      const auto face = boxFace(box, axis, upper);
      if (away > 0) view.faces.insert(view.faces.end(), face.begin(), face.end());
    }
}

/// The near plane, on which the rays of a viewer inside the box begin.
inline void addNearPlane(const VolumeCamera& camera, scene::VolumeView& view) {
  constexpr double kInside = 1e-9;  // of the near plane
  const glm::dmat4 dataFromWindow = glm::inverse(view.windowFromData);
  const auto at = [&](double x, double y) {
    const glm::dvec4 p = dataFromWindow * glm::dvec4(x * camera.pixels.x, y * camera.pixels.y, kInside, 1);
    return glm::dvec3(p) / p.w;
  };
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 0), std::pair(1, 1), std::pair(0, 1)})
    view.faces.push_back(at(x, y));
}

/// The view of all pixels. `inside`: the viewer is in the box.
inline scene::VolumeView viewOf(const VolumeCamera& camera, const VolumeBox& box, double step,
                                bool inside = false) {
  scene::VolumeView view;
  view.region = {0, 0, camera.pixels.x, camera.pixels.y};
  view.windowFromData = windowFromData(camera);
  view.textureFromData = textureFromData(box);
  view.viewer = camera.eye;
  if (camera.parallel) view.direction = glm::normalize(camera.target - camera.eye);
  view.step = static_cast<float>(step);
  for (int axis = 0; axis < 3; ++axis) {
    view.lower[axis] = static_cast<float>((view.textureFromData * glm::dvec4(box.lower, 1))[axis]);
    view.upper[axis] = static_cast<float>((view.textureFromData * glm::dvec4(box.upper, 1))[axis]);
  }
  if (inside)
    addNearPlane(camera, view);
  else
    addFrontFaces(box, view);
  return view;
}

/// Clips a view by planes of data space.
inline void clip(scene::VolumeView& view, const std::vector<glm::dvec4>& planes) {
  view.clipping = scene::VolumeClipping{planes, glm::inverse(view.textureFromData)};
}

/// Lights a volume by a light at the viewer. Returns the material of its first channel.
inline scene::VolumeMaterial& addViewerLight(scene::Volume& volume, bool twoSided = false) {
  volume.shading.model = scene::VolumeShading::Model::viewerReflected;
  volume.shading.twoSided = twoSided;
  volume.shading.lights.resize(1);
  return volume.channels[0].material;
}

}  // namespace gluray::test
