#include "saved/shot/turned_view.h"

#include "saved/shot/moved_view.h"
#include "scene/upward_axis.h"

#include <glm/gtc/matrix_transform.hpp>

#include <optional>

namespace gluray::saved {

std::vector<scene::SnapshotPtr> turned(const std::vector<scene::SnapshotPtr>& batches, double degrees) {
  std::vector<scene::SnapshotPtr> result;
  std::optional<glm::dvec3> axis;
  for (const scene::SnapshotPtr& batch : batches) {
    if (!axis) {
      glm::dvec3 up(0);
      up[scene::upwardAxis(batch->settings)] = 1;
      axis = glm::normalize(glm::dmat3(batch->eyeFromWorld) * up);
    }
    const Box box = boxOfView(*batch, batches);
    if (box.empty()) {
      result.push_back(batch);
      continue;
    }
    // The camera goes to the right where the scene turns to the left.
    const glm::dmat4 there = glm::translate(glm::dmat4(1), box.middle()),
                     back = glm::translate(glm::dmat4(1), -box.middle()),
                     by = there * glm::rotate(glm::dmat4(1), glm::radians(-degrees), *axis) * back;
    result.push_back(moved(*batch, by, box, Planes::roomy));
  }
  return result;
}

}  // namespace gluray::saved
