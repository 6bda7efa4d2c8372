#include "render/moving/light_history.h"

#include "render/remote/remote_surfaces.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

/// Whether two lists of numbers are equal up to the rounding of matrices.
bool isNear(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::abs(x - y) <= 1e-4f * std::max(1.0f, std::max(std::abs(x), std::abs(y)));
  });
}

}  // namespace

void LightHistory::begin(const FrameData& frame, const VisibilityIntegrator& integrator,
                         MovingFrame& moving) {
  constexpr float kMax = 16, kMaxSamplesAfterChange = 1;  // samples
  const scene::Snapshot& snapshot = *frame.snapshot;
  const int width = snapshot.region.width, height = snapshot.region.height;
  same_ = known_ && region_ == snapshot.region && settings_ == snapshot.settings &&
          isNear(meaning_, integrator.meaning()) && channels_ == Channels{integrator.used()};
  known_ = false;  // until it is finished
  settings_ = snapshot.settings, region_ = snapshot.region, meaning_ = integrator.meaning();
  moving.channels = channels_ = {integrator.used()};
  Frame &now = frames_[now_], &before = frames_[1 - now_];
  now.visibility.resize(width, height, moving.channels.count());
  hits_.resize(width, height, frame.edgesGrow);
  now.space = PixelSpace(frame);
  now.placement.rememberScene(snapshot);
  moving.space = now.space, moving.visibility = &now.visibility, moving.hits = &hits_;
  moving.mostSamples = kMax;
  moving.earlier = nullptr;
  if (!same_ || !before.space.usable) return;
  moving.earlier = &before.visibility, moving.earlierSpace = before.space;
  moving.reprojection = Reprojection(before.placement, before.space, now.placement, frame);
  if (moving.reprojection.changed || (frame.remote && frame.remote->changed()))
    moving.mostSamples = kMaxSamplesAfterChange;
}

size_t LightHistory::bytes() const {
  return frames_[0].visibility.bytes() + frames_[1].visibility.bytes() + hits_.bytes();
}

LightHistory& LightHistories::historyOf(uint64_t view) {
  for (auto it = views_.begin(); it != views_.end(); ++it) {
    if (it->view != view) continue;
    views_.splice(views_.begin(), views_, it);
    return views_.front().history;
  }
  if (views_.size() >= kMax) views_.pop_back();
  views_.push_front({view, {}});
  return views_.front().history;
}

size_t LightHistories::bytes() const {
  size_t sum = 0;
  for (const View& view : views_) sum += view.history.bytes();
  return sum;
}

}  // namespace gluray::render
