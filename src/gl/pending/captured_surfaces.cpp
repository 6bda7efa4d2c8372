#include "gl/pending/captured_surfaces.h"

#include "base/log.h"
#include "gl/basics/affine.h"
#include "gl/real/state_queries.h"
#include "parallel/loops.h"
#include "scene/world_space.h"

#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace gluray::gl {
namespace {

/// Pixels and window depths that a surface may have.
struct Extent {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // exclusive ends
  float nearest = 0, farthest = 1;
};

Extent whole(const scene::Region& r) { return {r.x, r.y, r.x + r.width, r.y + r.height}; }

Extent extentOf(const scene::Mesh& mesh, const glm::dmat4& clipFromObject,
                const scene::FramebufferCapture& capture) {
  Extent all = whole(capture.region);
  const auto corners = boundsInClip(mesh, clipFromObject);
  glm::dvec3 lower(INFINITY), upper(-INFINITY);
  for (const glm::dvec4& corner : corners) {
    if (!(corner.w > 0)) return all;  // reaches behind the viewer
    lower = glm::min(lower, glm::dvec3(corner) / corner.w);
    upper = glm::max(upper, glm::dvec3(corner) / corner.w);
  }
  const glm::ivec4& v = capture.viewport;
  const auto pixel = [](double ndc, int first, int size) {
    return static_cast<int>(std::floor(first + std::clamp((ndc + 1) / 2, -1.0, 2.0) * size));
  };
  all.x0 = std::max(all.x0, pixel(lower.x, v.x, v.z)),
  all.x1 = std::min(all.x1, pixel(upper.x, v.x, v.z) + 1);
  all.y0 = std::max(all.y0, pixel(lower.y, v.y, v.w)),
  all.y1 = std::min(all.y1, pixel(upper.y, v.y, v.w) + 1);
  if (!(capture.offset.factor == 0 && capture.offset.units == 0)) return all;
  const double n = double{capture.depthNear}, f = double{capture.depthFar};
  const auto depth = [&](double ndc) { return 0.5 * (f - n) * ndc + 0.5 * (f + n); };
  const double margin = 8 * double{capture.offset.resolution};
  all.nearest = static_cast<float>(std::min(depth(lower.z), depth(upper.z)) - margin);
  all.farthest = static_cast<float>(std::max(depth(lower.z), depth(upper.z)) + margin);
  return all;
}

scene::Region united(const std::vector<Extent>& extents) {
  Extent all{1, 1, 0, 0};
  for (const Extent& e : extents) {
    if (e.x1 <= e.x0 || e.y1 <= e.y0) continue;
    if (all.x1 <= all.x0) all = e;
    all.x0 = std::min(all.x0, e.x0), all.y0 = std::min(all.y0, e.y0);
    all.x1 = std::max(all.x1, e.x1), all.y1 = std::max(all.y1, e.y1);
  }
  return {all.x0, all.y0, std::max(0, all.x1 - all.x0), std::max(0, all.y1 - all.y0)};
}

std::vector<Extent> extentsOf(const scene::Snapshot& s, const scene::FramebufferCapture& capture) {
  std::vector<Extent> extents;
  extents.reserve(s.instances.size());
  for (const scene::Instance& instance : s.instances)
    extents.push_back(extentOf(*instance.mesh, s.camera.clipFromEye * instance.eyeFromObject, capture));
  return extents;
}

Hash128 contentOf(const scene::FramebufferCapture& p) {
  Hash128 hash = hashBytes(&p.viewport, sizeof p.viewport);
  const float ends[] = {p.depthNear, p.depthFar, p.offset.factor, p.offset.units, p.offset.resolution};
  hash = hashBytes(ends, sizeof ends, hash);
  const int place[] = {p.region.x, p.region.y, p.region.width, p.region.height};
  hash = hashBytes(place, sizeof place, hash);
  hash = hashLarge(p.colors.data(), p.colors.size() * sizeof(uint32_t), hash);
  return hashLarge(p.depths.data(), p.depths.size() * sizeof(float), hash);
}

}  // namespace

void mergeSamples(int width, const std::vector<float>& farthest, float resolution,
                  std::vector<float>& nearest) {
  constexpr float kSteps = 8;
  const auto columns = static_cast<size_t>(width), count = nearest.size();
  std::vector<float> merged(count);
  for (size_t i = 0; i < count; ++i) {
    const auto step = [&](bool before, bool after, size_t stride) {  // to the nearer one of two neighbours
      const float one = before ? std::abs(nearest[i] - nearest[i - stride]) : INFINITY,
                  other = after ? std::abs(nearest[i] - nearest[i + stride]) : INFINITY;
      return std::isfinite(std::min(one, other)) ? std::min(one, other) : 0;
    };
    const size_t x = i % columns;
    const float slope = step(x > 0, x + 1 < columns, 1) + step(i >= columns, i + columns < count, columns);
    const bool whole = farthest[i] - nearest[i] <= slope + kSteps * resolution;
    merged[i] = whole ? (farthest[i] + nearest[i]) / 2 : scene::FramebufferCapture::kNothing;
  }
  nearest = std::move(merged);
}

void leaveSurfaces(const scene::Snapshot& surfaces, scene::FramebufferCapture& capture) {
  constexpr double kMaxWork = 16;  // times the image: then all pixels stay
  const std::vector<Extent> extents = extentsOf(surfaces, capture);
  const auto width = static_cast<size_t>(capture.region.width);
  double work = 0;
  for (const Extent& e : extents) work += double(std::max(0, e.x1 - e.x0)) * std::max(0, e.y1 - e.y0);
  if (work > kMaxWork * static_cast<double>(capture.depths.size())) return;
  std::vector<uint8_t> stays(capture.depths.size(), 0);
  for (const Extent& e : extents)
    for (int y = e.y0; y < e.y1; ++y) {
      const size_t row = static_cast<size_t>(y - capture.region.y) * width;
      for (int x = e.x0; x < e.x1; ++x) {
        const size_t i = row + static_cast<size_t>(x - capture.region.x);
        stays[i] |= capture.depths[i] >= e.nearest && capture.depths[i] <= e.farthest;
      }
    }
  for (size_t i = 0; i < stays.size(); ++i)
    if (!stays[i]) capture.depths[i] = scene::FramebufferCapture::kNothing, capture.colors[i] = 0;
}

void CapturedSurfaces::add(const BatchKey& key, scene::Instance instance, scene::Shading shading,
                           const Batch& pending) {
  if (!batch_.empty() && !(batch_.key() == key)) collect(pending);
  if (batch_.empty())
    batch_.start(key, p_.shadow.target(), instance.eyeFromObject, p_.shadow.settings, p_.clock.frame);
  batch_.add(std::move(instance), std::move(shading));
}

bool CapturedSurfaces::readPixels(bool samples, scene::FramebufferCapture& p) {
  const RealGl& real = p_.shadow.real;
  FramebufferReader& reader = p_.presenter.reader();
  p_.shadow.errors.keepPending();
  if (!samples)
    return reader.readDepth(real, p.region, p.depths) && reader.readColors(real, p.region, p.colors);
  std::vector<float> farthest;
  if (!reader.readFarthest(real, p.region, true, p.depths) ||
      !reader.readFarthest(real, p.region, false, farthest) || !reader.readResolved(real, p.region, p.colors))
    return false;
  mergeSamples(p.region.width, farthest, p.offset.resolution, p.depths);
  return true;
}

std::shared_ptr<const scene::FramebufferCapture> CapturedSurfaces::captureOf(const BatchKey& key,
                                                                             const scene::Snapshot& s) {
  const RealGl& real = p_.shadow.real;
  const auto drawBuffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER));
  if (drawFramebuffer(real) != key.framebuffer || drawBuffer != key.drawBuffer) return nullptr;
  auto capture = std::make_shared<scene::FramebufferCapture>();
  capture->viewport = key.viewport;
  capture->depthNear = key.depthNear, capture->depthFar = key.depthFar;
  capture->region = key.region;
  capture->offset = key.offset;
  capture->offset.resolution = std::max(s.polygonOffset.resolution, 0x1p-24f);
  capture->region = united(extentsOf(s, *capture));
  const bool empty = capture->region.width == 0 || capture->region.height == 0;
  if (!empty) {
    if (!readPixels(key.samples > 1, *capture)) return nullptr;
    leaveSurfaces(s, *capture);
  }
  capture->content = contentOf(*capture);
  return capture;
}

/// The surfaces' eye space becomes that of the batch: programs give their matrices as one product.
void CapturedSurfaces::takeCamera(const BatchKey& beside) {
  last_ = beside;
  scene::Snapshot& s = batch_.unnumbered();
  const glm::dmat4 theirs = s.camera.clipFromEye;
  if (theirs == beside.projection || batch_.key().viewport != beside.viewport) return;
  const glm::dmat4 eyeFromClip = glm::inverse(beside.projection);
  std::vector<glm::dmat4> moved;
  for (const scene::Instance& instance : s.instances) {
    glm::dmat4& m = moved.emplace_back(eyeFromClip * (theirs * instance.eyeFromObject));
    if (!isAffine(m, reachOf(*instance.mesh))) return;
    m /= m[3][3];
    for (int c = 0; c < 4; ++c) m[c][3] = c == 3 ? 1.0 : 0.0;
  }
  s.camera.clipFromEye = beside.projection;
  s.eyeFromWorld = moved.front();
  const glm::dmat4 worldFromEye = glm::inverse(s.eyeFromWorld);
  for (size_t i = 0; i < moved.size(); ++i) {
    s.instances[i].eyeFromObject = moved[i];
    s.instances[i].worldFromObject = scene::worldFromObject(s.instances[i], s.eyeFromWorld, worldFromEye);
  }
}

void CapturedSurfaces::read(const BatchKey* beside) noexcept {
  try {
    const BatchKey key = batch_.key();
    if (beside && beside->framebuffer == key.framebuffer) takeCamera(*beside);
    const scene::SnapshotPtr surfaces = batch_.takeSnapshot();
    if (const auto capture = captureOf(key, *surfaces))
      p_.surfaces.views.traced(key, surfaces, capture);
    else
      log::once(log::Level::warning, "captured",
                "light.rasterised: the colours of a framebuffer cannot be read, so mirrors do not show the "
                "surfaces that the real OpenGL has drawn into it");
  } catch (const std::exception&) {
    log::once(log::Level::warning, "captured",
              "out of memory: mirrors do not show the surfaces that the real OpenGL has drawn");
  }
}

}  // namespace gluray::gl
