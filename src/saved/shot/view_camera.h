// Cameras as people and programs describe them, and those that matrices hold. Any thread.
#pragma once
#include <glm/glm.hpp>

#include <optional>

namespace gluray::saved {

/// A camera in a program's world space, whose lengths are those of the world.
struct ViewCamera {
  glm::dvec3 position{0, 0, 1}, focalPoint{0}, up{0, 1, 0};
  // The whole height of the view: an angle in degrees; or, of parallel projections, whose angle is 0, twice
  // this length.
  double viewAngle = 30, parallelScale = 1;
  bool isParallel() const { return viewAngle == 0; }
  bool operator==(const ViewCamera&) const = default;
};

/// The matrix from world space to that of the camera: x to the right, y up, the viewer at the origin, looking
/// along -z. None if the camera has no direction or no upward direction.
std::optional<glm::dmat4> cameraFromWorld(const ViewCamera& camera);

/// What a matrix to clip space says of the camera, in the space that it comes from.
struct SeenCamera {
  bool parallel = false;
  glm::dvec3 position{0};  // of a parallel projection: some point of the middle line
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  // of length 1; right angles if the space has them
  double halfHeight = 1;  // of the view: at distance 1, or of parallel projections everywhere
};
/// None if the matrix is no camera's.
std::optional<SeenCamera> seenCamera(const glm::dmat4& clipFromSpace);
bool isRectangular(const SeenCamera& seen);

/// Half the height of the view, as SeenCamera has it.
double halfHeightOf(const ViewCamera& camera);

/// Whether both views are equally high, up to this share.
bool areEquallyHigh(const SeenCamera& seen, const ViewCamera& camera, double within);
/// Whether both are the same camera: directions up to this length, places up to this share of the distance
/// from the focal point.
bool areAlike(const SeenCamera& seen, const ViewCamera& camera, double within);

}  // namespace gluray::saved
