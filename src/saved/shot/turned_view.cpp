#include "saved/shot/turned_view.h"

#include "saved/shot/derived_camera.h"
#include "saved/shot/moved_view.h"
#include "scene/upward_axis.h"

#include <glm/gtc/matrix_transform.hpp>

#include <optional>
#include <stdexcept>

namespace gluray::saved {

std::vector<scene::SnapshotPtr> turned(const std::vector<scene::SnapshotPtr>& batches, double degrees) {
  std::vector<scene::SnapshotPtr> result;
  std::optional<glm::dvec3> axis;  // in an even space of the first batch
  for (const scene::SnapshotPtr& batch : batches) {
    const std::optional<glm::dmat4> even = eyeFromEven(*batch);
    const glm::dmat4 eyeFromOwn = even.value_or(glm::dmat4(1)), ownFromEye = glm::inverse(eyeFromOwn);
    if (!axis) {
      glm::dvec3 up(0);
      up[scene::upwardAxis(batch->settings)] = 1;
      axis = glm::normalize(glm::dmat3(ownFromEye) * (glm::dmat3(batch->eyeFromWorld) * up));
    }
    const Box box = boxOfView(*batch, batches, ownFromEye);
    if (box.empty()) {
      result.push_back(batch);
      continue;
    }
    if (!even)
      throw std::runtime_error(
          "the scene cannot be turned: the program stretches objects along their axes, and no surface says "
          "how much");
    // The camera goes to the right where the scene turns to the left.
    const glm::dmat4 there = glm::translate(glm::dmat4(1), box.middle()),
                     back = glm::translate(glm::dmat4(1), -box.middle()),
                     by = there * glm::rotate(glm::dmat4(1), glm::radians(-degrees), *axis) * back;
    if (eyeFromOwn == glm::dmat4(1)) {
      result.push_back(moved(*batch, by, box, Planes::roomy));
    } else {
      const glm::dmat4 inEye = eyeFromOwn * by * ownFromEye;
      result.push_back(moved(*batch, inEye, boxOfView(*batch, batches, inEye), Planes::roomy));
    }
  }
  return result;
}

}  // namespace gluray::saved
