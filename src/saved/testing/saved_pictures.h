// Saved scenes and their pictures, for tests.
#pragma once
#include "frame/images/traced_images.h"
#include "frame/testing/mixed_scenes.h"
#include "saved/shot/shot.h"
#include "scene/premultiplied.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

namespace gluray::saved::test {

inline constexpr int kSide = 64;
inline constexpr uint32_t kBackground = 0xff604020;

inline SavedScene sceneOf(const scene::Snapshot& s) {
  SavedScene scene;
  scene.window = {s.region.width, s.region.height};
  scene.batches.push_back({std::make_shared<scene::Snapshot>(s)});
  return scene;
}

/// Without ambient occlusion.
inline scene::Snapshot unlit(scene::Snapshot s) {
  s.settings.ao.enabled = false;
  return s;
}

/// What the program gets of it, over a background; bottom row first.
inline std::vector<uint32_t> shownBy(const scene::Snapshot& s, uint32_t background = kBackground) {
  frame::test::CountingTrace tracer;
  frame::TracedImages images(frame::Tracer{.trace = tracer.trace});
  const auto result = images.imageOf(s, {.finished = true});
  EXPECT_TRUE(result.cached) << result.why;
  const Image& image = result.cached->image;
  std::vector<uint32_t> colors(image.depth.size(), background);
  for (size_t i = 0; i < colors.size(); ++i)
    if (image.depth[i] != Image::kMiss)
      colors[i] =
          image.isAverages() || s.layers ? scene::blended(image.color[i], background) : image.color[i];
  return colors;
}

/// All bands, top row first.
inline std::vector<uint32_t> rowsOf(Shot& shot) {
  std::vector<uint32_t> rows;
  for (int band = 0; band < shot.bands(); ++band) {
    const std::vector<uint32_t> some = shot.band(band);
    rows.insert(rows.end(), some.begin(), some.end());
  }
  return rows;
}

/// The same, bottom row first.
inline std::vector<uint32_t> pictureOf(Shot& shot) {
  const std::vector<uint32_t> rows = rowsOf(shot);
  const auto width = static_cast<ptrdiff_t>(shot.size().x);
  std::vector<uint32_t> flipped;
  for (auto row = rows.end(); row != rows.begin(); row -= width)
    flipped.insert(flipped.end(), row - width, row);
  return flipped;
}

inline std::vector<uint32_t> pictureOf(const SavedScene& scene, const ShotOptions& options = {}) {
  frame::Renderer renderer;
  Shot shot(scene, options, renderer);
  return pictureOf(shot);
}

inline int apart(uint32_t a, uint32_t b) {
  int most = 0;
  for (int shift = 0; shift < 24; shift += 8)
    most = std::max(most, std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
  return most;
}

}  // namespace gluray::saved::test
