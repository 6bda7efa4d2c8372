// Tests whether two batches have the same camera. OpenGL has no camera: eye space is factored out of the
// programs' matrices to clip space (gl/programs), so that equal cameras may differ by rounding, or by the
// origin of eye space. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::scene {

/// The matrix from the eye space of camera `from` to that of camera `to`, exactly the identity where they are
/// equal up to rounding. None if the cameras differ by more than rotation, translation and uniform scale.
/// `distance`: distance of the scenes from their origins, for the bound of rounding.
std::optional<glm::dmat4> eyeFromEye(const glm::dmat4& clipFromTo, const glm::dmat4& clipFromFrom,
                                     double distance);
/// The matrices of a camera. World space is the object space of the first draw.
struct CameraMatrices {
  glm::dmat4 clipFromEye, eyeFromWorld;
};
/// Uses the larger distance of the two world spaces' origins from their cameras.
std::optional<glm::dmat4> eyeFromEye(const CameraMatrices& to, const CameraMatrices& from);
/// The matrix between the eye spaces of two snapshots.
std::optional<glm::dmat4> eyeFromEye(const Snapshot& to, const Snapshot& from);

}  // namespace gluray::scene
