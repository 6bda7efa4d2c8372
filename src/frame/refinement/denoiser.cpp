#include "frame/refinement/denoiser.h"

#include "base/log.h"
#include "base/timeline.h"
#include "frame/refinement/oidn_filter.h"
#include "frame/refinement/pixel_noise.h"
#include "frame/refinement/refiner.h"
#include "parallel/arena.h"
#include "render/resolve/wavelet.h"
#include "render/tiles/float_guard.h"
#include "scene/effects.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gluray::frame {
namespace {

using render::WaveletTile;

/// As the kernels round.
uint32_t byteOf(float v) {
  return static_cast<uint32_t>(std::nearbyint((v > 0 ? std::min(v, 1.0f) : 0) * 255));
}

/// The part of an image with the samples of one number.
render::NoisyImage planeOf(const Refinement& r, const Image& image, size_t first, float target) {
  render::NoisyImage noisy;
  noisy.width = image.width, noisy.height = image.height, noisy.target = target;
  noisy.color = r.mean().data() + 4 * first;
  if (!image.has(Plane::wideColor)) noisy.most = 1;
  if (!r.pixelNoise().empty()) noisy.noise = r.pixelNoise().data() + first;
  noisy.features = {r.features.reflectance.data() + first, r.features.normal.data() + first,
                    r.features.facing.data() + first, r.features.distance.data() + first};
  return noisy;
}

void writePixel(const float* rgb, size_t at, Image& out) {
  if (out.has(Plane::wideColor)) return void(std::copy_n(rgb, 3, &out.wideColor[4 * at]));
  const uint32_t alpha = out.color[at] & 0xff000000u;
  out.color[at] = alpha | byteOf(rgb[0]) | byteOf(rgb[1]) << 8 | byteOf(rgb[2]) << 16;
}

void writeTile(const WaveletTile& tile, const float* smooth, size_t first, Image& out) {
  const int width = std::min(WaveletTile::kSize, out.width - tile.x),
            height = std::min(WaveletTile::kSize, out.height - tile.y);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t i = first + static_cast<size_t>(tile.y + y) * static_cast<size_t>(out.width) +
                       static_cast<size_t>(tile.x + x);
      if (out.depth[i] != Image::kMiss) writePixel(smooth + 3 * (y * WaveletTile::kSize + x), i, out);
    }
  }
}

struct Memory {
  std::vector<float> planes = std::vector<float>(render::waveletFloats());
  std::vector<float> out = std::vector<float>(size_t{3} * WaveletTile::kSize * WaveletTile::kSize);
};

void smooth(const render::NoisyImage& noisy, size_t first, Image& out) {
  const int columns = (out.width + WaveletTile::kSize - 1) / WaveletTile::kSize,
            rows = (out.height + WaveletTile::kSize - 1) / WaveletTile::kSize;
  tbb::enumerable_thread_specific<Memory> memories;
  tbb::parallel_for(0, columns * rows, [&](int index) {
    const render::FloatGuard guard;
    Memory& memory = memories.local();
    const WaveletTile tile{index % columns * WaveletTile::kSize, index / columns * WaveletTile::kSize};
    if (render::smoothTile(noisy, tile, memory.planes.data(), memory.out.data()))
      writeTile(tile, memory.out.data(), first, out);
  });
}

/// The same by Open Image Denoise. Pixels get the same share of its light as of the filter's
/// (render::smoothTile). False: the filter is to do it.
bool smoothByLibrary(const Refinement& refinement, const Settings& settings, size_t first, Image& out) {
  std::vector<float> colors;
  std::string why;
  const OidnLibrary* const library = oidnLibrary(why);
  if (!library || !smoothByOidn(*library, refinement, settings.threads, out, first, colors, why)) {
    if (library || settings.denoise == Denoise::oidn)
      log::once(log::Level::warning, "oidn",
                "no Open Image Denoise (setting denoise): " + why + "; GLuRay's own filter denoises images");
    return false;
  }
  const float target = settings.noise;
  for (size_t i = 0; i < colors.size() / 3; ++i) {
    const int x = static_cast<int>(i) % out.width, y = static_cast<int>(i) / out.width;
    const float* const mean = refinement.mean().data() + 4 * (first + i);
    const bool known = !refinement.pixelNoise().empty();
    const float noise = known ? noiseAbout(refinement.pixelNoise(), out, first, x, y) : 1;
    const float share = noise > target ? 1 - target * target / (noise * noise) : 0;
    if (out.depth[first + i] == Image::kMiss || !(share > 0)) continue;
    float rgb[3];
    for (size_t c = 0; c < 3; ++c) rgb[c] = mean[c] + share * (colors[3 * i + c] - mean[c]);
    writePixel(rgb, first + i, out);
  }
  return true;
}

}  // namespace

void keepFeatures(scene::LightSampling::Mode mode, const Image& pass, AuxiliaryFeatures& features) {
  const size_t pixels = pass.depth.size();
  if (mode == scene::LightSampling::Mode::reflectance) {
    features.reflectance.resize(pixels);
    render::packReflectances(pass.wideColor.data(), pixels, features.reflectance.data());
    return;
  }
  features.normal.resize(pixels), features.facing.resize(pixels), features.distance.resize(pixels);
  render::packGeometry(pass.wideColor.data(), pass.depth.data(), pixels, features.normal.data(),
                       features.facing.data(), features.distance.data());
}

bool wantsOidn(const Refinement& refinement, const Settings& settings) {
  if (settings.denoise != Denoise::automatic) return settings.denoise == Denoise::oidn;
  if (!isFinished(refinement, settings)) return false;
  const uint32_t passes = refinement.passes();
  if (scene::wantsPaths(settings)) return passes * static_cast<uint32_t>(settings.path.samples) <= kFewPaths;
  const int rays = std::max(scene::wantsOcclusion(settings) ? settings.ao.samples : 1,
                            scene::wantsShadows(settings) ? settings.shadows.samples : 1);
  return passes >= kMinPasses && passes * static_cast<uint32_t>(rays) <= kFewRays;
}

bool denoise(const Refinement& refinement, const Settings& settings, Image& out) noexcept {
  if (refinement.features.distance.size() != out.depth.size()) return true;
  try {
    const timeline::Span span("denoise");
    const size_t pixels = static_cast<size_t>(out.width) * static_cast<size_t>(out.height);
    sharedArena()->execute([&] {
      for (size_t first = 0; first < out.depth.size(); first += pixels)
        if (!wantsOidn(refinement, settings) || !smoothByLibrary(refinement, settings, first, out))
          smooth(planeOf(refinement, out, first, settings.noise), first, out);
    });
    return true;
  } catch (const std::exception&) {
    logNoFilter("out of memory");
    return false;
  }
}

void logNoFilter(const std::string& why) noexcept {
  try {
    log::once(log::Level::warning, "denoise", "cannot denoise an image: " + why + "; it keeps its noise");
  } catch (const std::exception&) {}
}

}  // namespace gluray::frame
