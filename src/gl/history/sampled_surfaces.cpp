#include "gl/history/sampled_surfaces.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>

namespace gluray::gl {

Hash128 hashOf(const glm::dmat4& matrix) {
  const glm::dmat4 m = matrix + 0.0;  // -0 is 0
  return hashBytes(glm::value_ptr(m), sizeof m);
}

void SampledSurfaces::add(const glm::dmat4& eyeFromObject, std::vector<Triangle> triangles,
                          const DepthStamp& at, bool pushedBack) {
  if (triangles.empty()) return;
  constexpr float kFar = std::numeric_limits<float>::max();
  Box box{glm::vec3(kFar), glm::vec3(-kFar), pushedBack, at};
  for (const Triangle& t : triangles)
    for (const glm::vec3& p : t) box.lower = glm::min(box.lower, p), box.upper = glm::max(box.upper, p);
  Group& group = groups_[hashOf(eyeFromObject)];
  group.triangles.push_back(std::move(triangles));
  group.boxes.push_back(box);
  ++size_;
}

bool SampledSurfaces::Box::meetsBoxOf(const scene::Mesh& mesh) const {
  return glm::all(glm::lessThanEqual(lower, mesh.upper)) && glm::all(glm::lessThanEqual(mesh.lower, upper));
}

}  // namespace gluray::gl
