#include "frame/refinement/noise_image.h"

#include "frame/refinement/pixel_noise.h"

#include <algorithm>
#include <cmath>

namespace gluray::frame {
namespace {

struct Rgb {
  float red, green, blue;
};

/// `times`: how often the allowed noise is in a pixel's.
Rgb colorOf(float times) {
  const auto ramp = [&](float from, float to) {
    return std::clamp((times - from) / (to - from), 0.0f, 1.0f);
  };
  return {ramp(0, 1), ramp(1, 2), ramp(2, 4)};
}

void paint(const Rgb& c, size_t pixel, Image& image) {
  const float rgb[] = {c.red, c.green, c.blue};
  if (image.has(Plane::wideColor)) return void(std::copy_n(rgb, 3, &image.wideColor[4 * pixel]));
  uint32_t bits = image.color[pixel] & 0xff000000u;
  for (unsigned i = 0; i < 3; ++i) bits |= static_cast<uint32_t>(std::nearbyint(rgb[i] * 255)) << (8 * i);
  image.color[pixel] = bits;
}

}  // namespace

void paintNoise(const std::vector<uint16_t>& noise, float allowed, Image& image) {
  const size_t pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
  const bool known = noise.size() == image.depth.size() && allowed > 0;
  for (size_t i = 0; i < image.depth.size(); ++i) {
    if (image.depth[i] == Image::kMiss) continue;
    const size_t at = i % pixels;
    const int x = static_cast<int>(at) % image.width, y = static_cast<int>(at) / image.width;
    paint(known ? colorOf(noiseAbout(noise, image, i - at, x, y) / allowed) : Rgb{1, 1, 1}, i, image);
  }
}

void paintNoNoise(Image& image) {
  for (size_t i = 0; i < image.depth.size(); ++i)
    if (image.depth[i] != Image::kMiss) paint({0, 0, 0}, i, image);
}

}  // namespace gluray::frame
