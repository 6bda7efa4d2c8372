#include "render/ground/catcher.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

void showTaken(const ColorRows& open, ColorRows& rows) {
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

void CatcherLook::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  if (hits.instance != catcher_) return light_->light(hits, rows);
  ColorRows open = rows;
  light_->lightAlone(hits, open);
  light_->light(hits, rows);
  showTaken(open, rows);
}

void AllCaught::apply(const ColoredHits& hits, const Visibility& visibility, ColorRows& rows) const noexcept {
  ColorRows open = rows;
  light_->lightAlone(hits, open);
  light_->apply(hits, visibility, rows);
  showTaken(open, rows);
}

}  // namespace gluray::render
