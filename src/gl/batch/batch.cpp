#include "gl/batch/batch.h"

#include "base/hash.h"
#include "scene/catcher_offset.h"
#include "scene/world_space.h"
#include "settings/samples.h"

#include <algorithm>
#include <atomic>

namespace gluray::gl {
namespace {

uint64_t viewOf(const BatchKey& key, const TargetState& target) {
  const auto number = [](int n) { return static_cast<uint64_t>(static_cast<unsigned>(n)); };
  const glm::ivec4& v = key.viewport;
  const uint64_t place[] = {target.context,  key.framebuffer == 0 ? uint64_t{target.drawable} : 0,
                            key.framebuffer, key.drawBuffer,
                            number(v.x),     number(v.y),
                            number(v.z),     number(v.w)};
  return hashBytes(place, sizeof place).low;
}

/// Returns a new snapshot number, unique in this process.
uint64_t newNumber() {
  static std::atomic<uint64_t> last{0};
  return ++last;
}

}  // namespace

scene::PolygonOffset Batch::offsetOf(const PixelState& state) {
  const RasterState& raster = state.raster;
  if (!raster.offsetFill) return {};
  return {raster.offsetFactor, raster.offsetUnits, state.target.offsetUnit, false, state.target.depthFloats};
}

BatchKey Batch::keyOf(const PixelState& state, const glm::dmat4& projection) {
  const ViewportState& viewport = state.viewport;
  BatchKey key;
  key.framebuffer = state.target.framebuffer;
  key.drawBuffer = state.target.drawBuffer;
  key.depthFunc = state.raster.depthFunc;
  key.depthsFromZero = state.raster.depthsFromZero;
  key.samples = state.target.samples;
  key.multisample = state.raster.multisample;
  key.colorWrites = state.raster.colorWrites;
  key.encodes = state.target.encodes;
  key.projection = projection;
  key.viewport = viewport.box;
  key.depthNear = viewport.depthNear, key.depthFar = viewport.depthFar;
  key.region = viewport.region();
  key.offset = offsetOf(state);
  return key;
}

void Batch::start(const BatchKey& key, const TargetState& target, const glm::dmat4& modelview,
                  const Settings& settings, uint64_t frame, scene::LightSampling::Mode mode) {
  key_ = key;
  instancesAt_.clear();
  snapshot_ = memory_.make();
  snapshot_->frame = frame;
  snapshot_->view = viewOf(key, target);
  snapshot_->number = newNumber();
  snapshot_->settings = settings;
  undithered_ = false;
  snapshot_->lightSampling.mode = mode;
  snapshot_->camera = {key.projection, key.viewport, key.depthNear, key.depthFar};
  // Window rows are counted from the top. This assumes that the viewport reaches it; errors hardly matter.
  if (key.framebuffer == 0) snapshot_->camera.rowsFromTop = key.viewport.y + key.viewport.w;
  snapshot_->camera.largestWins = key.keepsLargest();
  snapshot_->camera.depthsFromZero = key.depthsFromZero;
  snapshot_->eyeFromWorld = modelview;
  worldFromEye_ = glm::inverse(modelview);
  snapshot_->region = key.region;
  snapshot_->polygonOffset = key.offset;
  snapshot_->encodes = key.encodes;
  snapshot_->wideColors = target.wideColors || key.encodes;
  snapshot_->colorWrites = key.colorWrites;
  snapshot_->laterWins = key.depthFunc == GL_LEQUAL || key.depthFunc == GL_GEQUAL;
  if (key.layers == BatchKey::Layers::none) snapshot_->depthSteps = target.coarseDepthSteps();
  if (key.layers == BatchKey::Layers::drawn) {
    auto layers = std::make_shared<scene::Layers>();
    layers->of = scene::Layers::Of::drawn;
    layers->blending = key.blending;
    layers->depthSteps = key.depthSteps;
    layers->halfFloats = target.halfFloats;
    snapshot_->layers = std::move(layers);
  }
  drawn_ = 0;
  if (key.layers == BatchKey::Layers::visibility) return startVisibility(target);
  // With GL_MULTISAMPLE off all samples of a pixel get the value at its centre: one plane is enough.
  if (key.multisample) {
    snapshot_->samples = target.samples;
    snapshot_->samplePositions = target.samplePositions;
  } else {
    snapshot_->samplePositions = {glm::vec2(0.5f)};
  }
}

/// Sets one sample per pixel, in front of what the real OpenGL has drawn, whose depths differ by rounding.
void Batch::startVisibility(const TargetState& target) {
  const float slope = target.samples > 1 ? scene::kCatcherSlopeToSamples : scene::kCatcherSlope;
  constexpr uint64_t kOther = 0x9E3779B97F4A7C15;
  snapshot_->catches = true;
  snapshot_->view ^= kOther;  // its light history is separate from that of traced images
  snapshot_->samplePositions = {glm::vec2(0.5f)};
  const scene::PolygonOffset& own = key_.offset;
  snapshot_->polygonOffset = {own.factor + slope, own.units + scene::kCatcherUnits, target.offsetUnit, false,
                              target.depthFloats};
  takeOneSample(snapshot_->settings);  // the framebuffer's surfaces are sharp
}

void Batch::resume(const BatchKey& key, const scene::Snapshot& taken) {
  key_ = key;
  instancesAt_.clear();
  snapshot_ = memory_.make();
  *snapshot_ = taken;
  snapshot_->number = newNumber();
  worldFromEye_ = glm::inverse(taken.eyeFromWorld);
  drawn_ = static_cast<uint32_t>(taken.instances.size());
}

namespace {

/// Whether two instances cover the same points with equal depth, so that the depth function decides.
bool coincide(const scene::Instance& a, const scene::Instance& b) {
  return a.mesh->geometryId == b.mesh->geometryId && a.eyeFromObject == b.eyeFromObject && a.cull == b.cull &&
         a.frontFaceCcw == b.frontFaceCcw && a.clipPlanes == b.clipPlanes && a.impostors == b.impostors;
}

uint32_t indexOfShading(std::vector<scene::Shading>& shadings, scene::Shading&& shading) {
  // Programs switch between few states, most often between recent ones.
  constexpr size_t kLookBack = 16;
  for (size_t i = shadings.size(); i-- > 0 && shadings.size() - i <= kLookBack;)
    if (shadings[i] == shading) return static_cast<uint32_t>(i);
  shadings.push_back(std::move(shading));
  return static_cast<uint32_t>(shadings.size() - 1);
}

}  // namespace

void Batch::add(scene::Instance instance, scene::Shading shading) {
  scene::Snapshot& s = *snapshot_;
  instance.order = drawn_++;
  instance.worldFromObject = scene::worldFromObject(instance, s.eyeFromWorld, worldFromEye_);
  // Hashes the matrix, too: programs draw the same geometry thousands of times.
  const glm::dmat4 matrix = instance.eyeFromObject + 0.0;  // -0 is 0
  const Hash128 place = hashBytes(&matrix, sizeof matrix, instance.mesh->geometryId);
  const auto [first, last] = instancesAt_.equal_range(place);
  for (auto it = first; it != last; ++it) {
    scene::Instance& earlier = s.instances[it->second];
    if (key_.layers != BatchKey::Layers::none || !coincide(earlier, instance)) continue;
    const bool firstWins = key_.depthFunc == GL_LESS || key_.depthFunc == GL_GREATER;
    // The alpha test may cut holes into the surface that passes, and the other one is seen through them.
    if ((firstWins ? s.shadings[earlier.shading] : shading).alphaTest != scene::AlphaTest{}) continue;
    if (firstWins) return;
    instance.shading = indexOfShading(s.shadings, std::move(shading));
    earlier = std::move(instance);
    return;
  }
  instance.shading = indexOfShading(s.shadings, std::move(shading));
  instancesAt_.emplace(place, s.instances.size());
  s.instances.push_back(std::move(instance));
}

bool Batch::takes(const glm::dmat4& eyeFromObject) const {
  return eyeFromObject == snapshot_->eyeFromWorld ||
         scene::isPlaceable(glm::mat4(worldFromEye_ * eyeFromObject));
}

bool Batch::holdsData() const {
  if (!undithered_ || key_.layers != BatchKey::Layers::none || (key_.samples > 1 && key_.multisample))
    return false;
  using Model = scene::FragmentShading::Model;
  return std::ranges::all_of(snapshot_->shadings, [](const scene::Shading& s) {
    return s.fragment.model == Model::unlit || (s.fragment.model == Model::off && !s.lighting);
  });
}

scene::SnapshotPtr Batch::takeSnapshot() {
  instancesAt_.clear();
  return std::move(snapshot_);
}

bool Batch::readsImages() const { return readImages(programDraws_); }

bool readImages(const std::vector<ProgramDraw>& draws) {
  return std::any_of(draws.begin(), draws.end(), [](const ProgramDraw& draw) {
    return std::any_of(draw.textures.begin(), draw.textures.end(),
                       [](const auto& t) { return t.buffer == 0; });
  });
}

bool readsBuffer(const std::vector<ProgramDraw>& draws, GLuint buffer) {
  return std::any_of(draws.begin(), draws.end(), [&](const ProgramDraw& draw) {
    return std::any_of(draw.textures.begin(), draw.textures.end(),
                       [&](const auto& t) { return t.buffer != 0 && t.buffer == buffer; });
  });
}

}  // namespace gluray::gl
