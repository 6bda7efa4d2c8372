// Whether two batches are seen by one camera. OpenGL has no camera: programs give matrices to clip space,
// from which eye space is factored out (gl/programs), so that equal cameras may differ by rounding, or by
// where they put the origin of eye space. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::scene {

/// The matrix from the eye space of camera `from` to that of camera `to`, exactly the identity where they are
/// equal up to rounding. None where the cameras differ: where no rotation, translation and uniform scale
/// leads from one to the other. `distance`: of what they show, from their origins, for the bound of rounding.
std::optional<glm::dmat4> eyeFromEye(const glm::dmat4& clipFromTo, const glm::dmat4& clipFromFrom,
                                     double distance);
/// What a camera's matrices are. World space is the object space of what is drawn first.
struct CameraMatrices {
  glm::dmat4 clipFromEye, eyeFromWorld;
};
/// The same with the larger distance of the two world spaces' origins from their cameras.
std::optional<glm::dmat4> eyeFromEye(const CameraMatrices& to, const CameraMatrices& from);
/// The same of two snapshots.
std::optional<glm::dmat4> eyeFromEye(const Snapshot& to, const Snapshot& from);

}  // namespace gluray::scene
