#include "render/volumes/volume_rays.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

constexpr double kPixelCentre = 0.5;
constexpr double kEdge = 1e-9;  // of a face: no pixel between two faces may miss both by rounding
/// The corners (x, y, w) on the grid of window coordinates to which rasterisers round them. Those of a
/// triangle that is partly behind the viewer stay: clipping makes other corners of it.
glm::dmat3 onGrid(const glm::dmat3& corners) {
  constexpr double kGrid = 256;
  glm::dmat3 rounded;
  for (int c = 0; c < 3; ++c) {
    const glm::dvec3& p = corners[c];
    if (!(p.z > 0)) return corners;
    rounded[c] = glm::dvec3(glm::round(glm::dvec2(p) / p.z * kGrid) / kGrid, 1) * p.z;
  }
  return std::abs(glm::determinant(rounded)) > 0 ? rounded : corners;
}

glm::dvec3 affine(const glm::dmat4& m, const glm::dvec3& p) { return glm::dvec3(m * glm::dvec4(p, 1)); }

}  // namespace

VolumeRays::VolumeRays(const scene::VolumeView& view)
    : view_(view),
      textureFromWindow_(view.textureFromData * glm::inverse(view.windowFromData)),
      textureDirection_(view.textureFromData) {
  if (view.clipping) textureFromClip_ = glm::inverse(view.clipping->spaceFromTexture);
  for (size_t i = 0; i + 2 < view.faces.size(); i += 3) {
    Face face;
    glm::dmat3 corners;  // x, y, w
    for (int c = 0; c < 3; ++c) {
      face.corners[c] = view.faces[i + static_cast<size_t>(c)];
      const glm::dvec4 p = view.windowFromData * glm::dvec4(face.corners[c], 1);
      corners[c] = {p.x, p.y, p.w};
      face.depths[c] = p.z;
    }
    if (!(std::abs(glm::determinant(corners)) > 0)) continue;
    const glm::dmat3 barycentric = glm::transpose(glm::inverse(corners)),
                     rounded = glm::transpose(glm::inverse(onGrid(corners)));
    for (int c = 0; c < 3; ++c) face.edges[c] = barycentric[c], face.borders[c] = rounded[c];
    everyFace_.push_back(static_cast<uint32_t>(faces_.size()));
    faces_.push_back(face);
  }
}

TileRays::TileRays(const VolumeRays& rays, const Tile& tile) : rays_(rays) {
  const scene::Region& region = rays.view_.region;
  const glm::dvec2 corner(region.x, region.y);
  const glm::dvec2 lower = corner + glm::dvec2(tile.x0, tile.y0),
                   upper = corner + glm::dvec2(tile.x1, tile.y1);
  for (const uint32_t number : rays.everyFace_)
    if (!rays.faces_[number].misses(lower, upper)) faces_.push_back(number);
}

/// One of its borders, which are linear, has the whole rectangle on its outer side.
bool VolumeRays::Face::misses(const glm::dvec2& lower, const glm::dvec2& upper) const {
  constexpr double kMargin = 1;  // pixels
  for (const glm::dvec3& border : borders) {
    const glm::dvec2 farthest(border.x > 0 ? upper.x + kMargin : lower.x - kMargin,
                              border.y > 0 ? upper.y + kMargin : lower.y - kMargin);
    if (glm::dot(border, glm::dvec3(farthest, 1)) < 0) return true;
  }
  return false;
}

bool VolumeRays::Face::covers(const glm::dvec2& at) const {
  const glm::dvec3 p(at, 1);
  const glm::dvec3 b(glm::dot(borders[0], p), glm::dot(borders[1], p), glm::dot(borders[2], p));
  const double sum = b.x + b.y + b.z, outside = -kEdge * sum;
  return b.x >= outside && b.y >= outside && b.z >= outside && sum > 0;
}

bool VolumeRays::Face::coversPixel(const glm::dvec2& centre) const {
  const glm::dvec3 p(centre, 1);
  for (const glm::dvec3& border : borders)
    if (!(glm::dot(border, p) >= kPixelCentre * (std::abs(border.x) + std::abs(border.y)))) return false;
  return true;
}

VolumeRays::Entry VolumeRays::entryOf(int x, int y, const Faces& faces) const {
  const glm::dvec2 corner(view_.region.x + x, view_.region.y + y), centre = corner + kPixelCentre;
  Entry entry;
  for (const uint32_t number : faces)
    if (!entry.face && faces_[number].covers(centre)) entry.face = &faces_[number];
  if (view_.samplePositions.empty() || (entry.face && entry.face->coversPixel(centre))) return entry;
  size_t covered = 0;
  for (const glm::vec2& sample : view_.samplePositions)
    for (const uint32_t number : faces) {
      if (!faces_[number].covers(corner + glm::dvec2(sample))) continue;
      ++covered;
      if (!entry.face) entry.face = &faces_[number];
      break;
    }
  entry.covered = static_cast<double>(covered) / static_cast<double>(view_.samplePositions.size());
  return entry;
}

/// The first sample is always taken; another one if it lies inside the box and the one before it is not
/// beyond what ends the ray.
int VolumeRays::samplesOf(const VolumeRay& ray, const glm::dvec3& end) const {
  double most = kMostSamples;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = ray.step[axis];
    if (step == 0) continue;
    const double border = step > 0 ? view_.upper[axis] : view_.lower[axis];
    most = std::min(most, std::floor((border - ray.first[axis]) / step));
  }
  const double steps = glm::length(end - glm::dvec3(ray.first)) / glm::length(glm::dvec3(ray.step));
  if (steps >= 0) most = std::min(most, std::ceil(steps));  // false for what is no number
  return static_cast<int>(std::max(most, 0.0)) + 1;
}

/// Steps from the entry to the first sample.
double VolumeRays::startOf(int x, int y) const {
  if (view_.jitter.empty()) return 1;
  const auto wrapped = [](int at, int size) { return static_cast<size_t>((at % size + size) % size); };
  const size_t column = wrapped(view_.region.x + x, view_.jitterSize.x),
               row = wrapped(view_.region.y + y, view_.jitterSize.y);
  return view_.jitter[row * static_cast<size_t>(view_.jitterSize.x) + column];
}

bool VolumeRays::isInside(const glm::vec3& p) const {
  return glm::all(glm::greaterThanEqual(p, view_.lower)) && glm::all(glm::lessThanEqual(p, view_.upper));
}

/// Takes the parts beyond the clip planes away. False: nothing is left.
bool VolumeRays::clip(Line& line) const {
  const scene::VolumeClipping& clipping = *view_.clipping;
  const glm::dvec3 along = glm::normalize(clipping.spaceFromData * line.direction);
  glm::dvec3 begin = affine(clipping.spaceFromTexture, line.begin),
             end = affine(clipping.spaceFromTexture, line.end);
  for (const glm::dvec4& plane : clipping.planes) {
    const double atBegin = glm::dot(plane, glm::dvec4(begin, 1)), atEnd = glm::dot(plane, glm::dvec4(end, 1));
    if (atBegin < 0 && atEnd < 0) return false;
    const double slope = glm::dot(glm::dvec3(plane), along);
    if (slope > 0 && atBegin < 0) begin -= along * (atBegin / slope);
    if (slope < 0 && atEnd < 0) end -= along * (atEnd / slope);
  }
  line.begin = affine(textureFromClip_, begin), line.end = affine(textureFromClip_, end);
  return true;
}

void VolumeRays::castToSlice(const Line& line, float endDepth, VolumeRay& ray) const {
  constexpr double kParallel = 1e-6;
  const glm::dvec4& plane = view_.slice->plane;
  const double slope = glm::dot(glm::dvec3(plane), line.direction);
  const bool meets = std::abs(slope) > kParallel;
  const double distance = meets ? -glm::dot(plane, glm::dvec4(line.origin, 1)) / slope : -1;
  const glm::dvec4 data(line.origin + line.direction * distance, 1), window = view_.windowFromData * data;
  ray.first = glm::dvec3(view_.slice->textureFromData * data);
  if (!view_.depth.empty() && !(window.z / window.w < double{endDepth})) return;
  const bool inside = glm::all(glm::greaterThanEqual(ray.first, glm::vec3(0))) &&
                      glm::all(glm::lessThanEqual(ray.first, glm::vec3(1)));
  ray.samples = inside ? 1 : 0;
}

VolumeRays::FacePoint VolumeRays::pointOf(const Face& face, const glm::dvec2& pixel) {
  const glm::dvec3 at(pixel, 1);
  const glm::dvec3 b(glm::dot(face.edges[0], at), glm::dot(face.edges[1], at), glm::dot(face.edges[2], at));
  return {(b.x * face.corners[0] + b.y * face.corners[1] + b.z * face.corners[2]) / (b.x + b.y + b.z),
          glm::dot(b, face.depths)};
}

VolumeRay VolumeRays::at(int x, int y, const Faces& faces) const {
  if (view_.span) return spanAt(x, y, faces);
  VolumeRay ray;
  const Entry found = entryOf(x, y, faces);
  if (!found.face || found.covered == 0) return ray;
  const glm::dvec2 pixel(view_.region.x + x + kPixelCentre, view_.region.y + y + kPixelCentre);
  const FacePoint point = pointOf(*found.face, pixel);
  if (!point.visible()) return ray;
  const double depth = point.depth;
  const glm::dvec3& entry = point.data;
  ray.coverage = static_cast<float>(found.covered);
  const size_t index =
      static_cast<size_t>(y) * static_cast<size_t>(view_.region.width) + static_cast<size_t>(x);
  const float end = view_.depth.empty() ? 1.0f : view_.depth[index];
  ray.depth = static_cast<float>(depth);
  if (!(ray.depth < end) && !view_.depth.empty()) return ray;
  const glm::dvec3 away = view_.direction != glm::dvec3(0) ? view_.direction : entry - view_.viewer;
  ray.towardsViewer = glm::normalize(view_.viewer - entry);
  Line line{entry, glm::normalize(away)};
  if (view_.slice) return castToSlice(line, end, ray), ray;
  const glm::dvec4 last = textureFromWindow_ * glm::dvec4(pixel, end, 1);
  line.begin = affine(view_.textureFromData, entry), line.end = glm::dvec3(last) / last.w;
  if (view_.clipping && !clip(line)) return ray;
  const glm::dvec3 step = textureDirection_ * (line.direction * double{view_.step});
  ray.first = line.begin + step * startOf(x, y);
  ray.step = step;
  if (view_.clipping && !isInside(ray.first)) return ray;
  ray.samples = samplesOf(ray, line.end);
  return ray;
}

}  // namespace gluray::render
