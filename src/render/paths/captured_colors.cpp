#include "render/paths/captured_colors.h"

#include "accel/pages/page_cache.h"
#include "accel/rays/traceable.h"
#include "base/never_destroyed.h"
#include "scene/secondary_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

namespace gluray::render {
namespace {

using scene::CapturedSurface;
using scene::FramebufferCapture;

glm::vec3 colorOf(uint32_t rgba) { return glm::vec3(rgba & 255, rgba >> 8 & 255, rgba >> 16 & 255) / 255.0f; }

size_t pixelsOf(const FramebufferCapture& p) { return p.depths.size(); }

/// Clip coordinates with w = 1 of a window position.
glm::dvec4 ndcAt(const FramebufferCapture& p, double x, double y, double depth) {
  const glm::ivec4& v = p.viewport;
  const double n = double{p.depthNear}, f = double{p.depthFar};
  return {2 * (x - v.x) / v.z - 1, 2 * (y - v.y) / v.w - 1, (2 * depth - (f + n)) / (f - n), 1};
}

/// How far depths of one surface are from that of a pixel, within the pixel: the smaller step to a neighbour
/// along each axis, because the larger one may lead to another surface.
float toleranceAt(const FramebufferCapture& p, int x, int y) {
  constexpr float kSteps = 8;
  const auto width = static_cast<size_t>(p.region.width);
  const size_t i = static_cast<size_t>(y) * width + static_cast<size_t>(x);
  const auto step = [&](bool before, bool after, size_t stride) {
    float least = INFINITY;
    for (const bool next : {false, true})
      if (next ? after : before) {
        const float other = p.depths[next ? i + stride : i - stride];
        if (other != FramebufferCapture::kNothing) least = std::min(least, std::abs(other - p.depths[i]));
      }
    return std::isfinite(least) ? least : 0;
  };
  const float slope = step(x > 0, x + 1 < p.region.width, 1) + step(y > 0, y + 1 < p.region.height, width);
  const scene::PolygonOffset& offset = p.offset;
  return slope + kSteps * offset.resolution +
         2 * (std::abs(offset.factor) * slope + std::abs(offset.units) * offset.resolution);
}

/// A stretch of the line of sight through a pixel.
struct Stretch {
  glm::dvec3 start, way;
};

/// About the point that the pixel shows, world space. `worldFromClip`: of the image.
Stretch stretchAt(const FramebufferCapture& p, const glm::dmat4& worldFromClip, double x, double y,
                  double depth, double tolerance) {
  constexpr double kRounding = 4e-6;  // of coordinates that are floats
  const auto point = [&](double d) {
    const glm::dvec4 h = worldFromClip * ndcAt(p, x, y, std::clamp(d, 0.0, 1.0));
    return glm::dvec3(h) / h.w;
  };
  const glm::dvec3 middle = point(depth), a = point(depth - tolerance), b = point(depth + tolerance);
  const double reach = kRounding * (glm::length(middle) + glm::length(a));
  const glm::dvec3 way = glm::normalize(b - a) * std::max(glm::length(b - a) / 2, reach);
  return {middle - way, 2.0 * way};
}

/// What colours are made of: equal keys, equal colours.
Hash128 keyOf(const FrameData& frame) {
  const scene::Snapshot& s = *frame.snapshot;
  const scene::SecondaryScene& around = *s.secondaryScene;
  Hash128 key = hashBytes(&s.eyeFromWorld, sizeof s.eyeFromWorld);
  const size_t drawn = s.instances.size();
  key = hashBytes(&drawn, sizeof drawn, key);
  for (const auto& capture : around.captures) key = hashBytes(&capture->content, sizeof(Hash128), key);
  for (size_t i = 0; i < around.captured.size(); ++i) {
    const scene::Instance& instance = around.instances[i];
    key = hashBytes(&around.captured[i].capture, sizeof(uint32_t), key);
    key = hashBytes(&around.captured[i].clipFromObject, sizeof(glm::dmat4), key);
    key = hashBytes(&instance.eyeFromObject, sizeof(glm::dmat4), key);
    key = hashBytes(&instance.mesh->geometryId, sizeof(Hash128), key);
  }
  return key;
}

/// The colours of the last scenes: passes over an image have the same.
class LastColors {
 public:
  std::shared_ptr<const CapturedColors> of(const FrameData& frame) {
    const Hash128 key = keyOf(frame);
    {
      const std::lock_guard lock(mutex_);
      for (const auto& [known, colors] : last_)
        if (colors && known == key) return colors;
    }
    auto made = std::make_shared<const CapturedColors>(frame);
    const std::lock_guard lock(mutex_);
    last_[next_++ % last_.size()] = {key, made};
    return made;
  }

 private:
  std::mutex mutex_;
  std::array<std::pair<Hash128, std::shared_ptr<const CapturedColors>>, 3> last_;
  size_t next_ = 0;
};

LastColors& lastColors() {
  static NeverDestroyed<LastColors> last;
  return *last;
}

}  // namespace

std::shared_ptr<const CapturedColors> CapturedColors::create(const FrameData& frame) {
  const auto& around = frame.snapshot->secondaryScene;
  return around && !around->captures.empty() ? lastColors().of(frame) : nullptr;
}

CapturedColors::CapturedColors(const FrameData& frame) {
  const scene::Snapshot& s = *frame.snapshot;
  const scene::SecondaryScene& around = *s.secondaryScene;
  seen_.resize(scene::countAll(s));
  for (const auto& capture : around.captures) shown_.push_back({capture, {}, {}});
  std::vector<const glm::dmat4*> cameras(shown_.size());  // clip space of each image, from eye space
  for (size_t i = 0; i < around.captured.size(); ++i) {
    const CapturedSurface& captured = around.captured[i];
    Seen& seen = seen_[s.instances.size() + i];
    if (captured.capture == CapturedSurface::kNone) continue;
    seen.capture = &shown_[captured.capture];
    seen.objectFromEye = glm::inverse(around.instances[i].eyeFromObject);
    seen.clipFromEye = captured.clipFromObject * seen.objectFromEye;
    if (!cameras[captured.capture]) cameras[captured.capture] = &seen.clipFromEye;
  }
  for (size_t i = 0; i < shown_.size(); ++i)
    if (cameras[i]) find(frame, shown_[i], *cameras[i]), spread(frame, shown_[i]);
}

/// Finds out by rays which surface each pixel shows. `clipFromEye`: the image's clip space from the
/// frame's eye space.
void CapturedColors::find(const FrameData& frame, Shown& shown, const glm::dmat4& clipFromEye) const {
  const FramebufferCapture& p = *shown.capture;
  shown.instances.assign(pixelsOf(p), accel::kNoHit);
  shown.tolerances.assign(pixelsOf(p), 0);
  if (p.depthNear == p.depthFar) return;
  const glm::dmat4 worldFromClip = glm::inverse(clipFromEye * frame.snapshot->eyeFromWorld);
  const auto traceSome = [&](size_t first) {
    accel::RayPacket packet{};
    alignas(64) int32_t valid[kLanes];
    const auto width = static_cast<size_t>(p.region.width);
    for (int lane = 0; lane < kLanes; ++lane) {
      const size_t i = first + static_cast<size_t>(lane);
      valid[lane] = 0, packet.geometry[lane] = packet.instance[lane] = accel::kNoHit;
      packet.mask[lane] = ~0u, packet.id[lane] = static_cast<uint32_t>(lane);
      if (i >= pixelsOf(p) || p.depths[i] == FramebufferCapture::kNothing) continue;
      const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
      shown.tolerances[i] = toleranceAt(p, x, y);
      const Stretch at = stretchAt(p, worldFromClip, p.region.x + x + 0.5, p.region.y + y + 0.5,
                                   double{p.depths[i]}, double{shown.tolerances[i]});
      const glm::vec3 org(at.start), dir(at.way);
      packet.orgX[lane] = org.x, packet.orgY[lane] = org.y, packet.orgZ[lane] = org.z;
      packet.dirX[lane] = dir.x, packet.dirY[lane] = dir.y, packet.dirZ[lane] = dir.z;
      packet.tFar[lane] = 1;
      valid[lane] = accel::isTraceable(packet, lane) ? -1 : 0;
    }
    frame.world->intersectBounced(valid, packet);
    for (int lane = 0; lane < kLanes; ++lane)
      if (valid[lane] && packet.geometry[lane] != accel::kNoHit &&
          seen_[packet.instance[lane]].capture == &shown)
        shown.instances[first + static_cast<size_t>(lane)] = packet.instance[lane];
  };
  constexpr size_t kPiece = 64;  // packets
  const size_t packets = (pixelsOf(p) + kLanes - 1) / kLanes;
  tbb::parallel_for(size_t{0}, (packets + kPiece - 1) / kPiece, [&](size_t piece) {
    const accel::PageCache::Reader reader(frame.world->pages());
    for (size_t k = piece * kPiece; k < std::min(packets, (piece + 1) * kPiece); ++k) traceSome(k * kLanes);
  });
}

/// Gives surfaces the colours of the pixels that show them, in the order of the pixels.
void CapturedColors::spread(const FrameData& frame, Shown& shown) {
  const FramebufferCapture& p = *shown.capture;
  std::vector<size_t> count(seen_.size());
  for (const uint32_t instance : shown.instances)
    if (instance != accel::kNoHit) ++count[instance];
  for (size_t i = 0; i < seen_.size(); ++i) {
    const scene::Mesh& mesh = *scene::instanceOf(*frame.snapshot, i).mesh;
    if (count[i] > 0) seen_[i].colors.prepare(mesh.lower, mesh.upper, count[i]);
  }
  const auto width = static_cast<size_t>(p.region.width);
  glm::dvec3 sum(0);
  size_t all = 0;
  uint32_t last = accel::kNoHit;
  glm::dmat4 objectFromClip(1);
  for (size_t i = 0; i < pixelsOf(p); ++i) {
    const uint32_t instance = shown.instances[i];
    if (instance == accel::kNoHit) continue;
    Seen& seen = seen_[instance];
    if (instance != last)
      objectFromClip = seen.objectFromEye * glm::inverse(seen.clipFromEye), last = instance;
    const double x = p.region.x + static_cast<double>(i % width) + 0.5,
                 y = p.region.y + static_cast<double>(i / width) + 0.5;
    const glm::dvec4 object = objectFromClip * ndcAt(p, x, y, double{p.depths[i]});
    const glm::vec3 color = colorOf(p.colors[i]);
    seen.colors.add(glm::vec3(glm::dvec3(object) / object.w), color);
    sum += glm::dvec3(color), ++all;
  }
  for (size_t i = 0; i < seen_.size(); ++i)
    if (count[i] > 0) seen_[i].colors.finish();
  if (all > 0) shown.mean = glm::vec3(sum / static_cast<double>(all));
}

float CapturedColors::addPixels(const Shown& shown, uint32_t instance, const glm::dvec4& clip,
                                glm::vec3& sum) const {
  const FramebufferCapture& p = *shown.capture;
  const scene::Region& r = p.region;
  const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
  const double x = p.viewport.x + (ndc.x + 1) / 2 * p.viewport.z - r.x - 0.5,
               y = p.viewport.y + (ndc.y + 1) / 2 * p.viewport.w - r.y - 0.5;
  if (!(x > -1 && y > -1 && x < r.width && y < r.height)) return 0;
  const auto depth = static_cast<float>(0.5 * (double{p.depthFar} - double{p.depthNear}) * ndc.z +
                                        0.5 * (double{p.depthFar} + double{p.depthNear}));
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float shareX = static_cast<float>(x - x0), shareY = static_cast<float>(y - y0);
  float total = 0;
  for (int k = 0; k < 4; ++k) {
    const int column = x0 + (k & 1), row = y0 + (k >> 1);
    if (column < 0 || row < 0 || column >= r.width || row >= r.height) continue;
    const size_t i = static_cast<size_t>(row) * static_cast<size_t>(r.width) + static_cast<size_t>(column);
    if (shown.instances[i] != instance) continue;
    if (!(std::abs(p.depths[i] - depth) <= 2 * shown.tolerances[i])) continue;
    const float weight = (k & 1 ? shareX : 1 - shareX) * (k >> 1 ? shareY : 1 - shareY);
    sum += weight * colorOf(p.colors[i]), total += weight;
  }
  return total;
}

glm::vec3 CapturedColors::at(uint32_t instance, const glm::vec3& eye) const {
  constexpr float kEnough = 1e-3f;
  const Seen& seen = seen_[instance];
  const glm::dvec4 clip = seen.clipFromEye * glm::dvec4(eye, 1);
  glm::vec3 sum(0);
  const float weight = clip.w > 0 ? addPixels(*seen.capture, instance, clip, sum) : 0;
  if (weight > kEnough) return sum / weight;
  if (seen.colors.empty()) return seen.capture->mean;
  return seen.colors.at(glm::vec3(seen.objectFromEye * glm::dvec4(eye, 1)));
}

}  // namespace gluray::render
