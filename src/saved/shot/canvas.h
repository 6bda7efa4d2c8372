// A part of a picture, to which batches are added in the order of drawing, as a framebuffer takes them: one
// of bytes, or one of floats, whose colours are not rounded. Used by one thread at a time.
#pragma once
#include "base/image.h"
#include "scene/region.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::saved {

/// The depth test of a batch.
struct DepthTest {
  bool strict = true;        // equal depths fail
  bool largestWins = false;  // as scene::Camera::largestWins
  bool writesDepth = true;
  /// Whether a surface of this depth (Image::kMiss: none) shows over what has the depth `there`.
  bool passes(float depth, float there) const {
    if (depth == Image::kMiss) return false;
    return there == Image::kMiss || (largestWins ? depth > there : depth < there) ||
           (!strict && depth == there);
  }
};

class Canvas {
 public:
  /// Of so many samples per pixel, over these colours: RGBA8, premultiplied; empty: transparent. `region`:
  /// its pixels in the picture.
  Canvas(const scene::Region& region, int samples, const std::vector<uint32_t>& under = {});
  /// The same of floats: displayed values. `limits`: values that are drawn are limited to 0 .. 1.
  Canvas(const scene::Region& region, int samples, const std::vector<glm::vec4>& under, bool limits);

  const scene::Region& region() const { return region_; }
  int samples() const { return samples_; }
  /// Whether floats are limited.
  bool limits() const { return limits_; }
  /// Whether colours are floats.
  bool isWide() const { return !wide_.empty(); }
  /// Depths in the box (pixels of the picture) become those of an empty framebuffer.
  void clearDepth(const scene::Region& box);
  /// Adds an image of bytes or wide colours. `encodes`: the wide ones are linear. Averages of samples are
  /// premultiplied and cover pixels by their alpha. Pixels beside the canvas are left out.
  void add(const Image& image, const DepthTest& test, bool encodes);
  /// Adds premultiplied colours over those below, without a depth test.
  void addBlended(const Image& image, bool encodes);
  /// Adds order-independent sums (Image::kSums): their mean colour, by the opacity of all.
  void addSums(const Image& image);

  /// Premultiplied RGBA, means of samples, bottom row first.
  std::vector<uint32_t> colors() const;
  /// The same of floats, if isWide().
  std::vector<glm::vec4> wideColors() const;
  /// Window depths of first samples; negative where no surface is, as scene::Layers::opaqueDepth has them.
  std::vector<float> opaqueDepths(const scene::Region& part) const;
  /// RGBA8 of first samples.
  std::vector<uint32_t> colors(const scene::Region& part) const;

 private:
  /// Calls work(value of the image, value of the canvas) for the samples that both have.
  template <class Work>
  void eachValue(const Image& image, const Work& work) const;
  /// Draws a value of the image over one of the canvas. `opaque`: replaces it, whatever its alpha.
  void draw(const Image& image, size_t from, bool encodes, bool opaque, size_t to);

  scene::Region region_;
  int samples_;
  bool limits_ = false;
  std::vector<uint32_t> colors_;  // all pixels of the first sample, then those of the second ...
  std::vector<glm::vec4> wide_;   // in their place, if isWide()
  std::vector<float> depths_;     // Image::kMiss: none
};

}  // namespace gluray::saved
