#include "render/shading/matcap.h"

#include "render/local/texture_lookup.h"

namespace gluray::render {

glm::vec3 throughMatcap(const scene::FragmentShading& f, const glm::vec3& color, const glm::vec3& normal) {
  constexpr float kInwards = 0.98f;  // keeps filters within the images
  const glm::vec3 share = glm::clamp(color, 0.0f, 1.0f);
  const glm::vec3 at(glm::vec2(normal.x, -normal.y) * (kInwards / 2) + 0.5f, 0);
  const auto look = [&](size_t k) {
    const scene::Texture& t = f.matcap[k];
    return glm::vec3(sampleLevel(t, *t.image, t.magFilter, at));
  };
  return share.r * look(0) + share.g * look(1) + share.b * look(2) +
         (1 - share.r - share.g - share.b) * look(3);
}

}  // namespace gluray::render
