#include "render/remote/depths_first.h"

#include "accel/world.h"
#include "render/frame_data/frame_data.h"
#include "render/lights/lamps.h"
#include "render/tiles/tile.h"
#include "scene/box_corner.h"
#include "scene/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

/// Bounds of what a box covers: window pixels and order keys.
struct Covered {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
};

/// False: a part of the box lies beside the viewpoint or behind it.
bool cover(const FrameData& frame, const accel::Bounds& box, Covered& covered) {
  const scene::Snapshot& snapshot = *frame.snapshot;
  const glm::dmat4 clipFromWorld = snapshot.camera.clipFromEye * snapshot.eyeFromWorld;
  const glm::dvec4 viewport(snapshot.camera.viewport);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(scene::boxCorner(box.lower, box.upper, i), 1);
    if (!(clip.w > 0)) return false;
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const double depth = std::clamp(frame.depth.windowDepth(ndc.z), 0.0, 1.0);
    const glm::dvec3 at(viewport.x + (ndc.x + 1) / 2 * viewport.z, viewport.y + (ndc.y + 1) / 2 * viewport.w,
                        snapshot.camera.largestWins ? 1 - depth : depth);
    covered.lower = glm::min(covered.lower, at), covered.upper = glm::max(covered.upper, at);
  }
  return true;
}

/// Whether surfaces may show beyond the box that encloses them, because their size is one of the window.
bool growsInWindow(const FrameData& frame) {
  return frame.edgesGrow || std::ranges::any_of(frame.snapshot->instances, [](const scene::Instance& i) {
           return scene::isInWindow(i.mesh->shape);
         });
}

/// The tile that a distance from the image's edge falls into, and neighbours by rounding.
int tileAt(double pixel, double margin, int tiles) {
  const double tile = std::floor((pixel + margin) / kTileSize);
  return static_cast<int>(std::clamp(tile, -1.0, static_cast<double>(tiles)));
}

}  // namespace

DrawnPart drawnPart(const FrameData& frame) {
  const scene::Region& region = frame.snapshot->region;
  const int columns = (region.width + kTileSize - 1) / kTileSize,
            rows = (region.height + kTileSize - 1) / kTileSize;
  DrawnPart part;
  part.region = {region.x, region.y, region.width, region.height};
  part.tiles = {0, 0, columns, rows};
  part.nearest = 0, part.farthest = 1;
  Covered covered;
  if (growsInWindow(frame) || !cover(frame, frame.world->seenBounds(), covered)) return part;
  constexpr double kPixel = 1, kDepth = 1e-5;
  part.tiles = {std::max(tileAt(covered.lower.x - region.x, -kPixel, columns), 0),
                std::max(tileAt(covered.lower.y - region.y, -kPixel, rows), 0),
                std::min(tileAt(covered.upper.x - region.x, kPixel, columns) + 1, columns),
                std::min(tileAt(covered.upper.y - region.y, kPixel, rows) + 1, rows)};
  part.nearest = static_cast<float>(std::max(covered.lower.z - kDepth, 0.0));
  part.farthest = static_cast<float>(std::min(covered.upper.z + kDepth, 1.0));
  return part;
}

void clearTile(const Tile& tile, Image& image) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(image.width);
    const auto fill = [&](auto& plane, size_t values, auto value) {
      if (plane.empty()) return;
      const auto first =
          plane.begin() + static_cast<ptrdiff_t>(values * (row + static_cast<size_t>(tile.x0)));
      std::fill_n(first, values * static_cast<size_t>(tile.x1 - tile.x0), value);
    };
    fill(image.color, 1, image.missColor);
    fill(image.wideColor, 4, 0.0f);
    fill(image.depth, 1, Image::kMiss);
  }
}

float depthStep(const FrameData& frame) {
  constexpr float kFinest = 0x1p-22f;  // a few steps of a depth buffer of 24 bits, and of floats below 1
  const double steps = frame.snapshot->depthSteps;
  return steps > 0 ? std::max(kFinest, static_cast<float>(2 / steps)) : kFinest;
}

const char* reasonAgainstDepthsFirst(const FrameData& frame) {
  const scene::Snapshot& snapshot = *frame.snapshot;
  if (!snapshot.settings.depthFirst) return "the setting depth-first is off";
  if (snapshot.layers) return "translucent surfaces show what is behind them";
  if (frame.averages || frame.samplePositions.size() != 1) return "pixels have several samples";
  if (snapshot.catches) return "light is applied to what OpenGL has drawn";
  if (frame.catcher != accel::kNoHit || scene::wantsGround(snapshot.settings))
    return "a ground is in all processes";
  if (frame.lamps) return "visible lights stand before surfaces";
  if (frame.features) return "colours are features";
  const bool refined = snapshot.lightSampling.mode == scene::LightSampling::Mode::full;
  if (refined && snapshot.settings.denoise != Denoise::off)
    return "the denoiser reads pixels that other processes hide";
  return nullptr;
}

}  // namespace gluray::render
