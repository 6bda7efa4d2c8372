#include "gl/layers/peel_pauses.h"

#include <algorithm>

namespace gluray::gl {

PeelPauses::Pause* PeelPauses::find(const Pass& pass) noexcept {
  const auto at =
      std::find_if(pauses_.begin(), pauses_.end(), [&](const Pause& pause) { return pause.pass == pass; });
  return at == pauses_.end() ? nullptr : &*at;
}

bool PeelPauses::mayBegin(const Pass& pass, uint64_t frame) {
  if (inPass_ && passFrame_ == frame) {
    // A surface among labels: the next pass may be traced.
    if (!pass.label && ofLabels_)
      if (Pause* pause = find(first_)) pause->left = 0;
    return false;
  }
  inPass_ = false;
  Pause* pause = find(pass);
  if (!pause || pause->left == 0) return true;
  --pause->left;
  inPass_ = true, ofLabels_ = pause->labels, first_ = pass, passFrame_ = frame;
  return false;
}

void PeelPauses::failed(const Pass& pass, bool labels) {
  Pause* pause = find(pass);
  if (!pause) {
    if (pauses_.size() == kMost) pauses_.erase(pauses_.begin());
    pauses_.push_back({.pass = pass});
    pauses_.back().labels = labels;  // the first failure is followed by no pause
    return;
  }
  pause->left = pause->length;
  pause->length = std::min(pause->length * 2, kLongest);
  pause->labels = labels;
}

void PeelPauses::succeeded(const Pass& pass) noexcept {
  std::erase_if(pauses_, [&](const Pause& pause) { return pause.pass == pass; });
}

}  // namespace gluray::gl
