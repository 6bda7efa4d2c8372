// A part of a picture, to which batches are added in the order of drawing, as a framebuffer takes them.
// Used by one thread at a time.
#pragma once
#include "base/image.h"
#include "scene/region.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <vector>

namespace gluray::saved {

/// The depth test of a batch.
struct DepthTest {
  bool strict = true;        // equal depths fail
  bool largestWins = false;  // as scene::Camera::largestWins
  bool writesDepth = true;
};

class Canvas {
 public:
  /// Of so many samples per pixel, over these colours: RGBA8, premultiplied; empty: transparent. `region`:
  /// its pixels in the picture.
  Canvas(const scene::Region& region, int samples, const std::vector<uint32_t>& under = {});

  const scene::Region& region() const { return region_; }
  int samples() const { return samples_; }
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
  /// Window depths of first samples; negative where no surface is, as scene::Layers::opaqueDepth has them.
  std::vector<float> opaqueDepths(const scene::Region& part) const;
  /// RGBA8 of first samples.
  std::vector<uint32_t> colors(const scene::Region& part) const;

 private:
  /// Calls work(value of the image, value of the canvas) for the samples that both have.
  template <class Work>
  void eachValue(const Image& image, const Work& work) const;

  scene::Region region_;
  int samples_;
  std::vector<uint32_t> colors_;  // all pixels of the first sample, then those of the second ...
  std::vector<float> depths_;     // Image::kMiss: none
};

}  // namespace gluray::saved
