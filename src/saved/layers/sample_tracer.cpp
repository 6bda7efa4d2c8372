#include "saved/layers/sample_tracer.h"

#include "render/frame_data/frame_data.h"
#include "render/resolve/pixel_filter.h"
#include "saved/export/gather/scene_views.h"
#include "saved/shot/shot_frame.h"
#include "scene/effects.h"
#include "scene/srgb.h"
#include "settings/samples.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace gluray::saved {
namespace {

using Mode = scene::LightSampling::Mode;

/// From the eye space of a batch to the world of its view, and the camera there.
struct ViewSpace {
  glm::dmat4 worldFromEye{1};
  glm::dmat3 worldFromEyeNormal{1};
  glm::dvec3 viewpoint{0}, axis{0, 0, -1};  // the line of sight, unit length
  double depthOf(const glm::dvec3& world) const { return glm::dot(axis, world - viewpoint); }
};

/// Where all rays meet, eye space; the origin in parallel projections.
glm::dvec3 viewpointOf(const scene::Camera& camera) {
  const glm::dvec4 meet = glm::inverse(camera.clipFromEye)[2];
  const double far = glm::length(glm::dvec3(meet));
  return std::abs(meet.w) > 1e-12 * far ? glm::dvec3(meet) / meet.w : glm::dvec3(0);
}

/// Perpendicular to the picture, away from the viewer; eye space.
glm::dvec3 axisOf(const scene::Camera& camera) {
  const NearPlane plane(camera);
  const glm::dvec3 axis = glm::normalize(glm::cross(plane.right, plane.up));
  return glm::dot(axis, plane.away) < 0 ? -axis : axis;
}

ViewSpace spaceOf(const scene::Snapshot& first, const glm::dmat4& firstFromEye) {
  const glm::dmat4 worldFromFirst = glm::inverse(eyeFromWorldOf(first));
  ViewSpace space;
  space.worldFromEye = worldFromFirst * firstFromEye;
  space.worldFromEyeNormal = glm::transpose(glm::inverse(glm::dmat3(space.worldFromEye)));
  space.viewpoint = glm::dvec3(worldFromFirst * glm::dvec4(viewpointOf(first.camera), 1));
  // The world keeps the angles of eye space.
  space.axis = glm::normalize(glm::dmat3(worldFromFirst) * axisOf(first.camera));
  return space;
}

std::vector<ViewSpace> spacesOf(const std::vector<Shot::Placed>& batches) {
  std::vector<scene::SnapshotPtr> snapshots;
  for (const Shot::Placed& batch : batches)
    snapshots.emplace_back(scene::SnapshotPtr(), &batch.snapshot);  // owned by the batches
  std::vector<ViewSpace> spaces(batches.size());
  for (const ViewBatches& view : sceneViewsOf(snapshots))
    for (const ViewBatch& batch : view)
      for (size_t i = 0; i < batches.size(); ++i)
        if (batch.snapshot == &batches[i].snapshot)
          spaces[i] = spaceOf(*view.front().snapshot, batch.viewFromEye);
  return spaces;
}

/// The batch without light, through a closed lens, each pixel with one sample at its centre.
scene::Snapshot plain(const scene::Snapshot& given) {
  scene::Snapshot s = given;
  if (s.ground == scene::GroundUse::drawn && scene::wantsCatcher(s.settings))
    s.ground = scene::GroundUse::none;
  s.samples = 1, s.samplePositions.clear();
  s.wideColors = true, s.byteSamples = s.limitedSamples = false;
  s.secondaryScene.reset(), s.backdrop.reset();
  scene::dropLight(s.settings);
  takeOneSample(s.settings);
  s.settings.autoExposure = false, s.settings.look = Look::program;
  s.settings.shading = ShadingRate::pixel;
  return s;
}

size_t areaOf(const scene::Region& r) { return static_cast<size_t>(r.width) * static_cast<size_t>(r.height); }

}  // namespace

struct SampleTracer::Batch {
  scene::Snapshot snapshot;
  glm::dmat4 clipFromEye;  // through pixels' centres
  ViewSpace space;
  DepthTest test;
  std::vector<scene::Region> cleared;
  uint32_t firstSurface;
  bool translucent;
};

PixelSamples pixelSamples(const std::vector<Shot::Placed>& batches) {
  PixelSamples samples;
  for (const Shot::Placed& batch : batches) {
    const scene::Snapshot& s = batch.snapshot;
    if (s.layers) continue;
    render::FilteredSamples found;
    const bool composed = render::isComposed(s);
    if (composed || averagesSamples(s.settings, s.samples))
      found = render::filteredSamples(
          s.settings.pixelFilter,
          render::positionsInPixel(std::max(samplesPerPixel(s.settings), composed ? s.samples : 1)));
    else
      found.positions.assign(s.samplePositions.begin(), s.samplePositions.end());
    if (s.samples <= 1 && found.positions.empty()) found.positions = {glm::dvec2(0.5)};
    if (found.positions.size() <= samples.positions.size()) continue;
    samples = {std::move(found.positions), std::move(found.weights)};
  }
  if (samples.positions.empty()) samples.positions = {glm::dvec2(0.5)};
  samples.weights.resize(samples.positions.size(), 1);
  const auto nearest = std::min_element(
      samples.positions.begin(), samples.positions.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
        return glm::distance(a, glm::dvec2(0.5)) < glm::distance(b, glm::dvec2(0.5));
      });
  const auto at = nearest - samples.positions.begin();
  std::swap(samples.positions[0], *nearest),
      std::swap(samples.weights[0], samples.weights[static_cast<size_t>(at)]);
  return samples;
}

SampleTracer::SampleTracer(const Shot& shot, frame::Renderer& renderer, Wanted wanted)
    : renderer_(renderer), wanted_(wanted) {
  const std::vector<ViewSpace> spaces = spacesOf(shot.placed());
  uint32_t surface = 0;
  for (size_t i = 0; i < shot.placed().size(); ++i) {
    const Shot::Placed& placed = shot.placed()[i];
    const bool translucent = placed.snapshot.layers != nullptr;
    batches_.push_back({plain(placed.snapshot), placed.snapshot.camera.clipFromEye, spaces[i], placed.test,
                        placed.cleared, surface, translucent});
    surface += static_cast<uint32_t>(placed.snapshot.instances.size()) + 1;
  }
}

SampleTracer::~SampleTracer() = default;

void SampleTracer::trace(const scene::Region& region, const glm::dvec2& place, SurfaceSamples& out) {
  const size_t pixels = areaOf(region);
  out.windowDepth.assign(pixels, Image::kMiss);
  out.surface.assign(pixels, SurfaceSamples::kNone);
  if (wanted_.points) out.depth.resize(pixels), out.position.resize(pixels);
  if (wanted_.normals) out.normal.resize(pixels);
  if (wanted_.albedo) out.albedo.resize(pixels);
  for (Batch& batch : batches_) trace(batch, region, place, out);
}

void SampleTracer::render(Batch& batch, Mode mode) {
  batch.snapshot.lightSampling = {mode};
  // Reflectance is what paths know of a surface.
  batch.snapshot.settings.integrator =
      mode == Mode::reflectance ? LightIntegrator::path : LightIntegrator::local;
  scene::TraceCost cost;
  std::string error;
  if (!renderer_.render(batch.snapshot, image_, cost, error))
    throw std::runtime_error("its layers cannot be traced: " + error);
}

void SampleTracer::trace(Batch& batch, const scene::Region& region, const glm::dvec2& place,
                         SurfaceSamples& out) {
  const auto at = [&](int x, int y) {
    return static_cast<size_t>(y - region.y) * static_cast<size_t>(region.width) +
           static_cast<size_t>(x - region.x);
  };
  for (const scene::Region& box : batch.cleared) {
    const scene::Region part = common(box, region);
    for (int y = part.y; y < part.y + part.height; ++y)
      std::fill_n(out.windowDepth.begin() + static_cast<ptrdiff_t>(at(part.x, y)), part.width, Image::kMiss);
  }
  scene::Snapshot& s = batch.snapshot;
  const scene::Region whole = s.region, part = common(whole, region);
  if (batch.translucent || areaOf(part) == 0) return;
  s.region = part;
  const glm::dvec2 shift = -2.0 * (place - 0.5) / glm::dvec2(s.camera.viewport.z, s.camera.viewport.w);
  s.camera.clipFromEye = glm::translate(glm::dmat4(1), glm::dvec3(shift, 0)) * batch.clipFromEye;
  std::vector<uint8_t> passes(areaOf(part));
  const auto eachShown = [&](const auto& work) {
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x) {
        const size_t from = static_cast<size_t>(y) * static_cast<size_t>(part.width) + static_cast<size_t>(x);
        if (passes[from]) work(&image_.wideColor[4 * from], at(part.x + x, part.y + y));
      }
  };
  render(batch, Mode::points);
  for (size_t i = 0; i < passes.size(); ++i) {
    const size_t to =
        at(part.x + static_cast<int>(i) % part.width, part.y + static_cast<int>(i) / part.width);
    passes[i] = batch.test.passes(image_.depth[i], out.windowDepth[to]);
    if (passes[i] && batch.test.writesDepth) out.windowDepth[to] = image_.depth[i];
  }
  eachShown([&](const float* value, size_t to) {
    out.surface[to] = batch.firstSurface + static_cast<uint32_t>(std::lround(value[3])) - 1;
    if (!wanted_.points) return;
    const glm::dvec3 world(batch.space.worldFromEye * glm::dvec4(value[0], value[1], value[2], 1));
    out.position[to] = world, out.depth[to] = static_cast<float>(batch.space.depthOf(world));
  });
  if (wanted_.normals) {
    render(batch, Mode::surfaces);
    eachShown([&](const float* value, size_t to) {
      out.normal[to] =
          glm::normalize(batch.space.worldFromEyeNormal * glm::dvec3(value[0], value[1], value[2]));
    });
  }
  if (wanted_.albedo) {
    render(batch, Mode::reflectance);
    eachShown([&](const float* value, size_t to) {
      for (int c = 0; c < 3; ++c) out.albedo[to][c] = s.encodes ? scene::encodedSrgb(value[c]) : value[c];
    });
  }
  s.region = whole;
}

}  // namespace gluray::saved
