#include "scene/replaced_pixels.h"

#include "scene/premultiplied.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gluray::scene {
namespace {

constexpr int kChannels = 3;  // without alpha

int channelOf(uint32_t color, int channel) { return static_cast<int>(color >> (8 * channel) & 255u); }
int alphaOf(uint32_t color) { return static_cast<int>(color >> 24); }

struct Box {
  int left, bottom, right, top;  // the last two lie outside
};

/// The pixels of which any sample hits something.
Box boxOfHits(const Image& image) {
  Box box{image.width, image.height, 0, 0};
  for (int sample = 0; sample < image.samples; ++sample)
    for (int y = 0; y < image.height; ++y) {
      const auto row = static_cast<ptrdiff_t>(sample * image.height + y) * image.width;
      const auto first = image.depth.begin() + row, end = first + image.width;
      const auto isHit = [](float depth) { return depth != Image::kMiss; };
      const auto left = std::find_if(first, end, isHit);
      if (left == end) continue;
      const auto right =
          std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(left), isHit);
      box.left = std::min(box.left, static_cast<int>(left - first));
      box.right = std::max(box.right, static_cast<int>(right.base() - first));
      box.bottom = std::min(box.bottom, y), box.top = std::max(box.top, y + 1);
    }
  return box;
}

/// How one pixel of an image covers the framebuffer, with the mean of its samples' colours.
struct Covering {
  enum class Share : uint8_t { none, part, whole } share = Share::none;
  std::array<float, kChannels> color{};  // 0 .. 255, times the share
};

Covering coveringOf(const Image& image, size_t pixel) {
  const auto pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
  Covering found;
  int hits = 0;
  bool solid = true;
  for (size_t i = pixel; i < image.depth.size(); i += pixels) {
    if (image.depth[i] == Image::kMiss) continue;
    ++hits;
    solid = solid && (!image.isAverages() || alphaOf(image.color[i]) == 255);
    for (int c = 0; c < kChannels; ++c)
      found.color[static_cast<size_t>(c)] +=
          static_cast<float>(channelOf(image.color[i], c)) / static_cast<float>(image.samples);
  }
  using Share = Covering::Share;
  found.share = hits == 0 ? Share::none : hits == image.samples && solid ? Share::whole : Share::part;
  return found;
}

/// Compares an image with what the framebuffer shows in its place.
class Comparison {
 public:
  Comparison(const Image& written, const ShownPixels& shown)
      : written_(written), shown_(shown), whole_(shown.colors.size()) {
    for (size_t i = 0; i < whole_.size(); ++i)
      whole_[i] = coveringOf(written, i).share == Covering::Share::whole && isEqual(i);
  }
  bool isShown(size_t pixel) const {
    return whole_[pixel] || (coveringOf(written_, pixel).share == Covering::Share::part &&
                             hasShownNeighbour(pixel) && mayHold(pixel));
  }

 private:
  bool hasDepth(size_t pixel) const {
    if (shown_.depths.empty()) return true;
    const float depth = written_.isAverages() ? written_.centerDepth[pixel] : written_.depth[pixel];
    return depth == Image::kMiss || std::abs(depth - shown_.depths[pixel]) <= shown_.depthStep;
  }
  bool isEqual(size_t pixel) const {
    const float rounding = written_.samples > 1 ? 1.0f : 0.0f;  // of means
    const Covering covering = coveringOf(written_, pixel);
    for (int c = 0; c < kChannels; ++c)
      if (std::abs(covering.color[static_cast<size_t>(c)] -
                   static_cast<float>(channelOf(shown_.colors[pixel], c))) > rounding)
        return false;
    return hasDepth(pixel);
  }
  bool mayHold(size_t pixel) const {
    const Covering covering = coveringOf(written_, pixel);
    for (int c = 0; c < kChannels; ++c)
      if (static_cast<float>(channelOf(shown_.colors[pixel], c)) + 1 < covering.color[static_cast<size_t>(c)])
        return false;
    return hasDepth(pixel);
  }
  bool hasShownNeighbour(size_t pixel) const {
    const int x = static_cast<int>(pixel) % written_.width, y = static_cast<int>(pixel) / written_.width;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, written_.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, written_.width - 1); ++u)
        if (whole_[static_cast<size_t>(v) * static_cast<size_t>(written_.width) + static_cast<size_t>(u)])
          return true;
    return false;
  }

  const Image& written_;
  const ShownPixels& shown_;
  std::vector<bool> whole_;  // covered in full, and shown
};

/// The colour of a pixel that is an average of rays, of which some missed, after `before` was replaced.
uint32_t exchanged(uint32_t shown, uint32_t before, uint32_t now) {
  uint32_t color = shown & 0xff000000u;
  for (int c = 0; c < kChannels; ++c) {
    const int value = channelOf(shown, c) - channelOf(before, c) + channelOf(now, c);
    color |= static_cast<uint32_t>(std::clamp(value, 0, 255)) << (8 * c);
  }
  return color;
}

/// A pixel that an image covers in full, with the edges of later images that were blended over it.
class BlendedPixel {
 public:
  BlendedPixel(uint32_t color, float depth) : depth_(depth) {
    for (int c = 0; c < kChannels; ++c)
      color_[static_cast<size_t>(c)] = static_cast<float>(channelOf(color, c));
  }
  /// Blends the later image's pixel at (x, y) of the framebuffer, if it passes the depth test.
  void blend(const Image& over, bool largestWins, int x, int y) {
    const int u = x - over.x, v = y - over.y;
    if (u < 0 || v < 0 || u >= over.width || v >= over.height || over.samples != 1) return;
    const auto i = static_cast<size_t>(v) * static_cast<size_t>(over.width) + static_cast<size_t>(u);
    const float depth = over.depth[i];
    if (depth == Image::kMiss || (largestWins ? depth < depth_ : depth > depth_)) return;
    const float through = 1 - static_cast<float>(over.isAverages() ? alphaOf(over.color[i]) : 255) / 255;
    for (int c = 0; c < kChannels; ++c) {
      float& color = color_[static_cast<size_t>(c)];
      color = static_cast<float>(channelOf(over.color[i], c)) + through * color;
    }
    through_ *= through, ++blends_;
    const float written = over.isAverages() ? over.centerDepth[i] : depth;
    if (written != Image::kMiss) depth_ = written;
  }
  bool isShown(const ShownPixels& shown, size_t pixel) const {
    if (blends_ == 0 || through_ <= 0) return false;
    for (int c = 0; c < kChannels; ++c)  // each blend rounds
      if (std::abs(color_[static_cast<size_t>(c)] - static_cast<float>(channelOf(shown.colors[pixel], c))) >
          static_cast<float>(blends_))
        return false;
    return shown.depths.empty() || std::abs(depth_ - shown.depths[pixel]) <= shown.depthStep;
  }
  /// The shown colour after the image below was replaced.
  uint32_t replaced(uint32_t shown, uint32_t before, uint32_t now) const {
    uint32_t color = shown & 0xff000000u;
    for (int c = 0; c < kChannels; ++c) {
      const auto change = static_cast<float>(channelOf(now, c) - channelOf(before, c));
      const int value = channelOf(shown, c) + static_cast<int>(std::lround(through_ * change));
      color |= static_cast<uint32_t>(std::clamp(value, 0, 255)) << (8 * c);
    }
    return color;
  }
  float depth() const { return depth_; }

 private:
  std::array<float, kChannels> color_{};
  float depth_, through_ = 1;
  int blends_ = 0;
};

/// Replaces a pixel that shows `written` under later images. Returns whether it does.
bool replaceBlended(const Image& written, const Image& now, const ShownPixels& shown,
                    const LaterImages& later, size_t pixel, Image& out) {
  using Share = Covering::Share;
  if (written.samples != 1 || coveringOf(written, pixel).share != Share::whole ||
      coveringOf(now, pixel).share != Share::whole)
    return false;
  const int x = written.x + static_cast<int>(pixel) % written.width,
            y = written.y + static_cast<int>(pixel) / written.width;
  BlendedPixel blended(written.color[pixel], written.depth[pixel]);
  for (const auto& part : later.parts) blended.blend(*part, later.largestWins, x, y);
  if (!blended.isShown(shown, pixel)) return false;
  out.color[pixel] = blended.replaced(shown.colors[pixel], written.color[pixel], now.color[pixel]);
  out.depth[pixel] = blended.depth();
  return true;
}

}  // namespace

Image writtenPart(const Image& image) {
  Image part;
  if (!image.has(Plane::color) || !image.has(Plane::depth)) return part.resize(0, 0, 1), part;
  const Box box = boxOfHits(image);
  const Planes planes =
      image.isAverages() ? Image::kColorDepth | Plane::centerDepth : Planes(Image::kColorDepth);
  part.x = image.x + box.left, part.y = image.y + box.bottom;
  part.resize(std::max(box.right - box.left, 0), std::max(box.top - box.bottom, 0), image.samples, planes);
  const auto copyRows = [&](const auto& from, auto& to) {
    if (to.empty()) return;
    for (int sample = 0; sample < part.samples; ++sample)
      for (int y = 0; y < part.height; ++y)
        std::copy_n(from.begin() +
                        static_cast<ptrdiff_t>(sample * image.height + box.bottom + y) * image.width +
                        box.left,
                    part.width, to.begin() + static_cast<ptrdiff_t>(sample * part.height + y) * part.width);
  };
  copyRows(image.color, part.color);
  copyRows(image.depth, part.depth);
  copyRows(image.centerDepth, part.centerDepth);
  return part;
}

size_t findReplaced(const Image& written, const Image& now, const ShownPixels& shown, Image& out,
                    const LaterImages& later) {
  const auto pixels = static_cast<size_t>(written.width) * static_cast<size_t>(written.height);
  out.x = written.x, out.y = written.y;
  out.resize(written.width, written.height, written.samples);
  out.missColor = 0;
  std::fill(out.depth.begin(), out.depth.end(), Image::kMiss);
  const bool alike = now.x == written.x && now.y == written.y && now.width == written.width &&
                     now.height == written.height && now.samples == written.samples &&
                     (now.isAverages() || !written.isAverages());
  if (!alike || shown.colors.size() != pixels) return 0;
  const Comparison comparison(written, shown);
  size_t count = 0;
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    if (!comparison.isShown(pixel)) {
      count += !later.parts.empty() && replaceBlended(written, now, shown, later, pixel, out);
      continue;
    }
    ++count;
    for (size_t i = pixel; i < out.depth.size(); i += pixels) {
      if (written.depth[i] == Image::kMiss || now.depth[i] == Image::kMiss) continue;
      const bool blends = written.isAverages() && alphaOf(written.color[i]) != 255;
      if (blends)
        out.color[i] = exchanged(shown.colors[pixel], written.color[i], now.color[i]);
      else if (written.isAverages() || !now.isAverages())
        out.color[i] = now.color[i];
      else if (alphaOf(now.color[i]) == 0)
        continue;
      else
        out.color[i] = opaque(now.color[i]);
      out.depth[i] = now.depth[i];
    }
  }
  return count;
}

void replaceUnder(Layers& layers, const Region& region, const Image& before, const Image& now) {
  constexpr float kStep = 1.0f / (1 << 23);  // of depths of 24 bits
  if (before.samples != 1 || layers.colors.empty()) return;
  const auto placeOf = [&](int x, int y) -> std::optional<size_t> {
    const int u = before.x + x - region.x, v = before.y + y - region.y;
    if (u < 0 || v < 0 || u >= region.width || v >= region.height) return std::nullopt;
    return static_cast<size_t>(v) * static_cast<size_t>(region.width) + static_cast<size_t>(u);
  };
  ShownPixels shown;
  shown.depthStep = kStep;
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x) {
      const auto place = placeOf(x, y);
      shown.colors.push_back(place ? layers.colors[*place] : 0);
      shown.depths.push_back(place ? layers.opaqueDepth[*place] : Image::kMiss);
    }
  Image replaced;
  if (findReplaced(before, now, shown, replaced) == 0) return;
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x) {
      const auto i = static_cast<size_t>(y) * static_cast<size_t>(before.width) + static_cast<size_t>(x);
      if (const auto place = placeOf(x, y); place && replaced.depth[i] != Image::kMiss)
        layers.colors[*place] = replaced.color[i];
    }
}

}  // namespace gluray::scene
