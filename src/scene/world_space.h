// The world of a snapshot: the object space of its first instance. Any thread.
#pragma once
#include "scene/snapshot.h"

namespace gluray::scene {

/// Instance::worldFromObject of an instance whose eyeFromObject is set. `eyeFromWorld`: Snapshot's;
/// `worldFromEye`: its inverse.
inline glm::mat4 worldFromObject(const Instance& instance, const glm::dmat4& eyeFromWorld,
                                 const glm::dmat4& worldFromEye) {
  return instance.eyeFromObject == eyeFromWorld ? glm::mat4(1)
                                                : glm::mat4(worldFromEye * instance.eyeFromObject);
}

/// Whether rays can be transformed into an instance by the inverse of its `worldFromObject`: the matrix is
/// affine, finite and not nearly singular.
bool isPlaceable(const glm::mat4& worldFromObject);

}  // namespace gluray::scene
