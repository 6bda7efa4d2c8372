#include "bench/ospray/our_scene.h"

#include "bench/render/settings.h"
#include "bench/render/wavelet_snapshot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gluray::bench {

OurScene::OurScene(const TriangleMesh& mesh, int threads, const std::vector<std::string>& settings)
    : snapshot_(waveletSnapshot(mesh)) {
  snapshot_.settings.threads = threads;
  snapshot_.settings.bvh = BvhQuality::full;
  for (const std::string& setting : settings) set(snapshot_.settings, setting);
  // Towards the light, in eye space: above the viewer's right shoulder.
  snapshot_.shadings[0].lights[0].position = {0.45f, 0.6f, 0.66f, 0};
}

void OurScene::frame(const CameraPose& pose, Image& image) {
  snapshot_.lightSampling.mode = scene::LightSampling::Mode::moving;
  render(pose, image);
  snapshot_.lightSampling = {};
}

void OurScene::render(const CameraPose& pose, Image& image) {
  lookFrom(snapshot_, pose);
  ++snapshot_.frame;
  std::string error;
  scene::TraceCost cost;
  if (!renderer_.render(snapshot_, image, cost, error)) throw std::runtime_error(error);
}

void OurScene::pass(const CameraPose& pose, bool accumulate) {
  if (!accumulate) sum_.clear(), passes_ = 0;
  snapshot_.lightSampling = {};
  snapshot_.lightSampling.pass = passes_++;
  snapshot_.wideColors = true;
  render(pose, image_);
  snapshot_.wideColors = false;
  snapshot_.lightSampling = {};
  sum_.resize(image_.wideColor.size());
  for (size_t i = 0; i < sum_.size(); ++i) sum_[i] += double{image_.wideColor[i]};
}

std::vector<uint32_t> OurScene::pixels() const {
  std::vector<uint32_t> pixels(sum_.size() / 4);
  for (size_t i = 0; i < pixels.size(); ++i)
    for (unsigned c = 0; c < 4; ++c)
      pixels[i] |= static_cast<uint32_t>(std::lround(255 * std::clamp(sum_[4 * i + c] / passes_, 0.0, 1.0)))
                   << (8 * c);
  return pixels;
}

std::vector<uint8_t> OurScene::hits() const {
  std::vector<uint8_t> hits(image_.depth.size());
  for (size_t i = 0; i < hits.size(); ++i) hits[i] = image_.depth[i] != Image::kMiss;
  return hits;
}

}  // namespace gluray::bench
