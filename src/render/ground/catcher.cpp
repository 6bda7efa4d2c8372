#include "render/ground/catcher.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

void CatcherLook::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  if (!catchers_.all && hits.instance != catchers_.instance) {
    if (light_) light_->light(hits, rows);
    return;
  }
  ColorRows open = rows;
  if (light_) light_->lightAlone(hits, open), light_->light(hits, rows);
  // Rec. 709
  const auto luminance = [](const ColorRows& r, int i) {
    return 0.2126f * r.value[0][i] + 0.7152f * r.value[1][i] + 0.0722f * r.value[2][i];
  };
  for (int i = 0; i < kLanes; ++i) {
    const float all = luminance(open, i), left = luminance(rows, i) / all;
    rows.value[3][i] = all > 0 && std::isfinite(left) ? 1 - std::clamp(left, 0.0f, 1.0f) : 0.0f;
    for (int c = 0; c < 3; ++c) rows.value[c][i] = 0;
  }
}

}  // namespace gluray::render
