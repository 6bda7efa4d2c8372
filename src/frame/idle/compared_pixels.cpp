#include "frame/idle/compared_pixels.h"

namespace gluray::frame {

bool isVisible(const Compared& compared, glm::ivec2 at) {
  constexpr int kReach = 3;
  const uint32_t color = *compared.shownAt(at) & kColors;
  return compared.around(at, kReach, [&](glm::ivec2 place, size_t pixel) {
    if (compared.equal[pixel]) return true;
    const uint32_t* const shown = compared.shownAt(place);
    return !shown || (*shown & kColors) != color;
  });
}

}  // namespace gluray::frame
