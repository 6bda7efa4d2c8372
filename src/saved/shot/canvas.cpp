#include "saved/shot/canvas.h"

#include "render/resolve/averaged_byte.h"
#include "scene/premultiplied.h"
#include "scene/srgb.h"

#include <algorithm>
#include <cmath>

namespace gluray::saved {
namespace {

uint32_t bytesOf(const float* rgba, bool encodes) {
  uint32_t bytes = render::displayedByte(rgba[3], false) << 24;
  for (int c = 0; c < 3; ++c)
    bytes |= render::displayedByte(encodes ? scene::encodedSrgb(rgba[c]) : rgba[c], false) << (8 * c);
  return bytes;
}

uint32_t colorOf(const Image& image, size_t value, bool encodes) {
  return image.has(Plane::wideColor) ? bytesOf(&image.wideColor[4 * value], encodes) : image.color[value];
}

/// A displayed value, premultiplied.
glm::vec4 wideColorOf(const Image& image, size_t value, bool encodes, bool limits) {
  if (!image.has(Plane::wideColor)) return scene::wideOf(image.color[value]);
  const float* const from = &image.wideColor[4 * value];
  glm::vec4 color(from[0], from[1], from[2], std::clamp(from[3], 0.0f, 1.0f));
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(color[c])) color[c] = 0;
    if (encodes) color[c] = scene::encodedSrgb(color[c]);
    if (limits) color[c] = std::clamp(color[c], 0.0f, 1.0f);
  }
  return color;
}

size_t pixelsOf(const scene::Region& r) {
  return static_cast<size_t>(r.width) * static_cast<size_t>(r.height);
}

/// A rectangle without planes.
Image shapeOf(const scene::Region& r) {
  Image image;
  image.x = r.x, image.y = r.y, image.width = r.width, image.height = r.height;
  return image;
}

}  // namespace

Canvas::Canvas(const scene::Region& region, int samples, const std::vector<uint32_t>& under)
    : region_(region), samples_(samples) {
  const size_t values = pixelsOf(region) * static_cast<size_t>(samples);
  depths_.assign(values, Image::kMiss);
  if (under.empty()) colors_.assign(values, 0);
  for (int sample = 0; sample < samples && !under.empty(); ++sample)
    colors_.insert(colors_.end(), under.begin(), under.end());
}

Canvas::Canvas(const scene::Region& region, int samples, const std::vector<glm::vec4>& under, bool limits)
    : region_(region), samples_(samples), limits_(limits) {
  depths_.assign(pixelsOf(region) * static_cast<size_t>(samples), Image::kMiss);
  if (under.empty()) wide_.assign(depths_.size(), glm::vec4(0));
  for (int sample = 0; sample < samples && !under.empty(); ++sample)
    wide_.insert(wide_.end(), under.begin(), under.end());
}

template <class Work>
void Canvas::eachValue(const Image& image, const Work& work) const {
  const int left = std::max(image.x, region_.x), bottom = std::max(image.y, region_.y);
  const int right = std::min(image.x + image.width, region_.x + region_.width);
  const int top = std::min(image.y + image.height, region_.y + region_.height);
  const auto at = [](int sample, int x, int y, int width, int height) {
    return static_cast<size_t>((int64_t{sample} * height + y) * width + x);
  };
  for (int sample = 0; sample < samples_; ++sample)
    for (int y = bottom; y < top; ++y)
      for (int x = left; x < right; ++x)
        work(at(std::min(sample, image.samples - 1), x - image.x, y - image.y, image.width, image.height),
             at(sample, x - region_.x, y - region_.y, region_.width, region_.height));
}

void Canvas::clearDepth(const scene::Region& box) {
  eachValue(shapeOf(box), [&](size_t, size_t to) { depths_[to] = Image::kMiss; });
}

void Canvas::draw(const Image& image, size_t from, bool encodes, bool opaque, size_t to) {
  if (isWide()) {
    const glm::vec4 color = wideColorOf(image, from, encodes, limits_);
    wide_[to] = opaque ? glm::vec4(glm::vec3(color), 1) : scene::blended(color, wide_[to]);
    return;
  }
  const uint32_t color = colorOf(image, from, encodes);
  colors_[to] = opaque ? color | 0xff000000u : scene::blended(color, colors_[to]);
}

void Canvas::add(const Image& image, const DepthTest& test, bool encodes) {
  const bool averages = image.isAverages();
  eachValue(image, [&](size_t from, size_t to) {
    const float depth = image.depth[from];
    float& there = depths_[to];
    if (!test.passes(depth, there)) return;
    draw(image, from, encodes, !averages, to);
    const float written = averages ? image.centerDepth[from] : depth;
    if (test.writesDepth && written != Image::kMiss) there = written;
  });
}

void Canvas::addBlended(const Image& image, bool encodes) {
  eachValue(image, [&](size_t from, size_t to) {
    if (image.depth[from] != Image::kMiss) draw(image, from, encodes, false, to);
  });
}

void Canvas::addSums(const Image& image) {
  eachValue(image, [&](size_t from, size_t to) {
    const float* const sums = &image.wideColor[4 * from];
    const float opacity = 1 - image.transmittance[from];
    if (!(sums[3] > 0) || !(opacity > 0)) return;
    const float share = opacity / sums[3];
    const float color[4] = {sums[0] * share, sums[1] * share, sums[2] * share, opacity};
    if (isWide())
      wide_[to] = scene::blended(glm::vec4(color[0], color[1], color[2], color[3]), wide_[to]);
    else
      colors_[to] = scene::blended(bytesOf(color, false), colors_[to]);
  });
}

std::vector<uint32_t> Canvas::colors() const {
  const size_t pixels = colors_.size() / static_cast<size_t>(samples_);
  const auto count = static_cast<uint32_t>(samples_);
  std::vector<uint32_t> means(pixels);
  for (size_t i = 0; i < pixels; ++i)
    for (int shift = 0; shift < 32; shift += 8) {
      uint32_t sum = 0;
      for (size_t at = i; at < colors_.size(); at += pixels) sum += colors_[at] >> shift & 255u;
      means[i] |= (sum + count / 2) / count << shift;
    }
  return means;
}

std::vector<glm::vec4> Canvas::wideColors() const {
  const size_t pixels = wide_.size() / static_cast<size_t>(samples_);
  std::vector<glm::vec4> means(wide_.begin(), wide_.begin() + static_cast<ptrdiff_t>(pixels));
  for (size_t at = pixels; at < wide_.size(); ++at) means[at % pixels] += wide_[at];
  if (samples_ > 1)
    for (glm::vec4& mean : means) mean /= static_cast<float>(samples_);
  return means;
}

std::vector<float> Canvas::opaqueDepths(const scene::Region& part) const {
  std::vector<float> depths(pixelsOf(part), -1.0f);
  const Canvas first(part, 1);
  first.eachValue(shapeOf(region_), [&](size_t from, size_t to) {
    if (depths_[from] != Image::kMiss) depths[to] = depths_[from];
  });
  return depths;
}

std::vector<uint32_t> Canvas::colors(const scene::Region& part) const {
  std::vector<uint32_t> colors(pixelsOf(part));
  const Canvas first(part, 1);
  first.eachValue(shapeOf(region_), [&](size_t from, size_t to) {
    colors[to] = isWide() ? bytesOf(&wide_[from].x, false) : colors_[from];
  });
  return colors;
}

}  // namespace gluray::saved
