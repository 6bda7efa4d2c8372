#include "render/moving/light_history.h"

#include "render/remote/remote_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

/// Whether two lists of numbers are equal up to the rounding of matrices.
bool isNear(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::abs(x - y) <= 1e-4f * std::max(1.0f, std::max(std::abs(x), std::abs(y)));
  });
}

/// How far lights have moved at most, as chords of angles. Infinity: they are others.
float wayOf(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& now) {
  float most = 0;
  for (size_t i = 0; before.size() == now.size() && i < now.size(); ++i) {
    const float way = glm::distance(before[i], now[i]) / std::max(1.0f, glm::length(now[i]));
    if (!(way <= most)) most = way;  // not >: what is no number has moved
  }
  return before.size() == now.size() ? most : std::numeric_limits<float>::infinity();
}

/// Most samples of shadows' history that count where lights have moved so far. With a ray a pixel, shadows
/// without history are as exact; with fewer, old shadows are better than none while they are about the same.
float shadowSamples(float way, bool quarter) {
  constexpr float kRounding = 1e-4f, kAboutTheSame = 0.09f;
  if (way <= kRounding) return VisibilityBuffer::kMaxSamples;
  return quarter && way <= kAboutTheSame ? 0.5f : 0.0f;
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
  now.lights = integrator.lightPlaces();
  moving.space = now.space, moving.visibility = &now.visibility, moving.hits = &hits_;
  moving.mostSamples = kMax;
  moving.earlier = nullptr;
  if (!same_ || !before.space.usable) return;
  moving.earlier = &before.visibility, moving.earlierSpace = before.space;
  moving.mostLightSamples = shadowSamples(wayOf(before.lights, now.lights), moving.rays.quarter);
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
