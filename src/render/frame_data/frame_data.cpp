#include "render/frame_data/frame_data.h"

#include "render/camera/focus.h"
#include "render/camera/lens.h"
#include "render/edges/grown_triangles.h"
#include "render/lights/lamps.h"
#include "render/lights/relit.h"
#include "render/resolve/pixel_filter.h"
#include "scene/catcher_offset.h"
#include "scene/effects.h"
#include "scene/secondary_scene.h"
#include "settings/samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace gluray::render {
namespace {

bool clipPlanesShared(const std::vector<scene::Instance>& instances) {
  return std::all_of(instances.begin(), instances.end(),
                     [&](const scene::Instance& i) { return i.clipPlanes == instances.front().clipPlanes; });
}

bool writesDepth(const scene::Shading& shading) { return shading.fragment.writesDepth; }

/// Upper bound of the stretch of a matrix: the root of a bound of the largest eigenvalue of m^T m.
double stretchOf(const glm::dmat3& m) {
  const glm::dmat3 squared = glm::transpose(m) * m;
  double most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, glm::dot(glm::abs(squared[c]), glm::dvec3(1)));
  return std::sqrt(most);
}

/// FrameData::leastDepthReach. A triangle's slope is its depth extent divided by its width in the window. A
/// shift by some pixels' worth of slope moves it by at most its longest edge, times these pixels, divided by
/// its width.
double reachOfLeastDepth(const FrameData& frame, bool atCenters) {
  constexpr double kHalfDiagonal = 0.7072;  // of a pixel: from a sample to the centre
  constexpr double kThinnest = 0.1;         // pixels; thinner triangles cover hardly a sample
  if (frame.depth.floatUnits != 0) return std::numeric_limits<double>::infinity();
  const double nearer = (atCenters ? kHalfDiagonal : 0) - frame.depth.slopeFactor;
  if (nearer <= 0) return 0;
  double longest = 0;
  for (const scene::Instance& instance : frame.snapshot->instances) {
    longest = std::max(
        longest, stretchOf(glm::dmat3(instance.eyeFromObject)) * frame.world->longestEdge(*instance.mesh));
  }
  return longest * nearer / kThinnest;
}

/// Fills lightings of what rays from the viewer meet, and edgesGrow.
void addLightings(FrameData& frame) {
  const std::vector<scene::Shading>& own = frame.shadings();
  const scene::SecondaryScene* around = frame.snapshot->secondaryScene.get();
  frame.lightings.reserve(own.size() + (around ? around->shadings.size() : 0));
  for (const scene::Shading& shading : own) {
    frame.lightings.emplace_back(shading);
    frame.edgesGrow = frame.edgesGrow || (shading.fragment.edges && shading.fragment.edgesGrow);
  }
}

/// Whether all surfaces are clipped at the rays, which get the planes then. Triangles that grow by their
/// edges are clipped by their corners' distances from the planes, and fragment programs discard clipped
/// fragments at the position where they run.
bool clipAtRays(FrameData& frame) {
  const scene::Snapshot& s = *frame.snapshot;
  const bool discarded =
      frame.oncePerPixel && std::any_of(s.shadings.begin(), s.shadings.end(), scene::isProgram);
  if (frame.edgesGrow || discarded || !clipPlanesShared(s.instances)) return false;
  if (s.instances.empty()) return true;
  // A plane acts on eye coordinates; as a row vector, times the modelview matrix, it acts on world
  // coordinates.
  for (const glm::dvec4& plane : s.instances.front().clipPlanes)
    frame.rays.clipPlanes.push_back(plane * s.eyeFromWorld);
  return true;
}

/// Fills surfaces. Throws std::runtime_error for an instance without shading or material.
void addSurfaces(FrameData& frame, const View& view, bool clippedAtRays) {
  const scene::Snapshot& s = *frame.snapshot;
  frame.surfaces.resize(s.instances.size());
  tbb::parallel_for(size_t{0}, frame.surfaces.size(), [&](size_t i) {
    const scene::Instance& instance =
        frame.relit && !frame.relit->instances.empty() ? frame.relit->instances[i] : s.instances[i];
    if (instance.shading >= s.shadings.size()) throw std::runtime_error("an instance has no shading state");
    if (instance.materials.empty()) throw std::runtime_error("an instance has no material");
    if (instance.mesh->triangleCount == 0) return;
    frame.surfaces[i] = makeSurface(view, instance, frame.lightings[frame.shadingOf(i)], clippedAtRays);
    if (frame.honest) frame.honest->apply(i, frame.surfaces[i]);
  });
}

class AcceptedHits : public accel::HitFilter {
 public:
  explicit AcceptedHits(const std::vector<Surface>& surfaces) : surfaces_(surfaces) {}
  bool accepts(uint32_t instance, uint32_t primitive, float u, float v, int) const noexcept override {
    return surfaces_[instance].accepts(primitive, u, v);
  }

 private:
  const std::vector<Surface>& surfaces_;
};

/// Sets leastDepth and what belongs to it, and `accepted`.
void prepareLeastDepth(FrameData& frame) {
  const scene::Snapshot& s = *frame.snapshot;
  const auto mayRefuse = [](const Surface& f) { return f.cullsCcw || f.cullsCw || f.ownClipPlanes; };
  const bool atCenters = frame.oncePerPixel && std::any_of(s.shadings.begin(), s.shadings.end(), writesDepth);
  const bool uncertain = scene::ordersBySlope(s) || atCenters || s.depthSteps > 0;
  frame.leastDepth = uncertain && frame.depth.scale != 0 && !s.layers;
  if (frame.leastDepth) {
    frame.leastDepthReach = reachOfLeastDepth(frame, atCenters);
    const glm::dmat4 rows = glm::transpose(s.camera.clipFromEye * s.eyeFromWorld);
    frame.clipZ = rows[2], frame.clipW = rows[3];
  }
  if ((frame.edgesGrow || frame.leastDepth) &&
      std::any_of(frame.surfaces.begin(), frame.surfaces.end(), mayRefuse))
    frame.accepted = std::make_unique<AcceptedHits>(frame.surfaces);
}

/// FrameData::samplePositions without those that an average adds. Throws std::runtime_error for a wrong
/// number.
std::vector<glm::dvec2> positionsOf(const scene::Snapshot& s, bool averages) {
  const bool composed = averages && isComposed(s);
  std::vector<glm::dvec2> positions =
      positionsInPixel(averages ? std::max(samplesPerPixel(s.settings), composed ? s.samples : 1) : 1);
  const int samples = averages ? 1 : s.samples;
  if (samples > 1) positions.assign(s.samplePositions.begin(), s.samplePositions.end());
  if (!averages && positions.size() != static_cast<size_t>(std::max(samples, 1)))
    throw std::runtime_error("the number of sample positions is not the number of samples");
  return positions;
}

}  // namespace

bool isComposed(const scene::Snapshot& s) {
  if (s.layers) return false;
  return s.backdrop || (s.ground == scene::GroundUse::drawn && scene::wantsCatcher(s.settings));
}

FrameData::~FrameData() = default;

void FrameData::prepareAverages() {
  FilteredSamples samples = filteredSamples(snapshot->settings.pixelFilter, std::move(samplePositions));
  samplePositions = std::move(samples.positions), sampleWeights = std::move(samples.weights);
  const float sum = sampleWeights.empty() ? static_cast<float>(samplePositions.size())
                                          : std::accumulate(sampleWeights.begin(), sampleWeights.end(), 0.0f);
  averageFactor = 1 / sum;
  if (!hasOpenLens(snapshot->settings)) return;
  lens = makeLens(*snapshot, distanceInFocus(*snapshot, rays, *world, AcceptedHits(surfaces)));
  if (!lens) return;
  samplePositions.insert(samplePositions.begin(), samplePositions.front());
  if (!sampleWeights.empty()) sampleWeights.insert(sampleWeights.begin(), 0.0f);
}

FrameData::FrameData(const scene::Snapshot& s, const accel::World& w, Image& target)
    : world(&w),
      snapshot(&s),
      rays(makeRaySetup(s, w.lower(), w.upper())),
      eyeRays(makeEyeRays(s, rays)),
      depth(makeDepthMap(s)),
      relit(relight(s, eyeRays)),
      image(&target) {
  perVertex = s.settings.shading == ShadingRate::vertex;
  averages = target.isAverages();
  bytes = target.has(Plane::color) || (averages && s.byteSamples);
  limits = averages && s.limitedSamples;
  using Mode = scene::LightSampling::Mode;
  features = s.lightSampling.mode == Mode::reflectance || s.lightSampling.mode == Mode::geometry;
  const int samples = averages ? 1 : s.samples;
  oncePerPixel = samples > 1 && s.settings.shading != ShadingRate::sample;
  tone = litTone = makeToneMap(s);
  if (s.settings.look == Look::honest) honest.emplace(s), relit = nullptr;
  addLightings(*this);
  const View view(s.camera);
  addSurfaces(*this, view, clipAtRays(*this));
  prepareLeastDepth(*this);
  ownPlanes = std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& f) { return f.ownClipPlanes; });
  samplePositions = positionsOf(s, averages);
  if (averages) prepareAverages();
  if (edgesGrow)
    grown = std::make_unique<GrownTriangles>(
        GrowthStage{s, surfaces, depth, accepted.get(), image->width, image->height, samplePositions});
  if (averages && s.backdrop) backdrop.emplace(s, eyeRays);
  for (size_t i = 0; i < s.instances.size() && scene::wantsCatcher(s.settings); ++i)
    if (s.instances[i].ground) catcher = static_cast<uint32_t>(i);
  if (s.catches && !lens && !averages) knownDepths = findKnownDepths(s, rays, w);
  if (s.secondaryScene) addSecondaryScene(view);
  if (relit) lamps = makeLamps(s, *relit, eyeRays, depth);
}

void FrameData::exposeLit(float factor) {
  litTone = makeToneMap(*snapshot, factor);
  if (backdrop) backdrop->expose(*snapshot, factor);
}

/// After all that rays from the viewer meet is known: they do not meet these.
void FrameData::addSecondaryScene(const View& view) {
  const scene::SecondaryScene& around = *snapshot->secondaryScene;
  const size_t drawn = surfaces.size(), first = lightings.size();
  const bool relights = relit && !relit->secondaryShadings.empty();
  for (const scene::Shading& shading : relights ? relit->secondaryShadings : around.shadings)
    lightings.emplace_back(shading);
  surfaces.resize(drawn + around.instances.size());
  tbb::parallel_for(size_t{0}, around.instances.size(), [&](size_t i) {
    const scene::Instance& instance = around.instances[i];
    if (instance.mesh->triangleCount == 0) return;
    try {
      surfaces[drawn + i] = makeSurface(view, instance, lightings[first + instance.shading], false);
    } catch (const std::runtime_error&) {}  // its matrix cannot be inverted: rays meet nothing there
  });
}

const std::vector<scene::Shading>& FrameData::shadings() const {
  if (honest) return honest->shadings();
  return relit ? relit->shadings : snapshot->shadings;
}

int FrameData::lightSamplesEach(int count) const {
  if (!averages) return count;
  const int samples = std::max(static_cast<int>(samplePositions.size()) - (lens ? 1 : 0), 1);
  return std::max(1, (count + samples - 1) / samples);
}

uint32_t FrameData::firstLightSample(int sample, int count) const {
  const auto perPixel = static_cast<uint32_t>(std::max<size_t>(samplePositions.size(), 1));
  const uint32_t pass = snapshot->lightSampling.pass;
  return (pass * perPixel + static_cast<uint32_t>(sample)) * static_cast<uint32_t>(count);
}

uint32_t FrameData::shadingOf(size_t instance) const {
  return relit ? relit->shadingOf[instance] : snapshot->instances[instance].shading;
}

}  // namespace gluray::render
