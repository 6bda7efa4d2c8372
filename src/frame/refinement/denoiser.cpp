#include "frame/refinement/denoiser.h"

#include "base/log.h"
#include "base/timeline.h"
#include "frame/refinement/oidn_filter.h"
#include "frame/refinement/pixel_noise.h"
#include "frame/refinement/refiner.h"
#include "parallel/arena.h"
#include "render/resolve/averaged_byte.h"
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

/// The part of an image with the samples of one number.
render::NoisyImage planeOf(const Refinement& r, const Image& image, size_t first, float target) {
  render::NoisyImage noisy;
  noisy.width = image.width, noisy.height = image.height, noisy.target = target;
  noisy.color = r.mean().data() + 4 * first;
  if (!image.has(Plane::wideColor)) noisy.most = render::kBrightest;
  if (!r.pixelNoise().empty()) noisy.noise = r.pixelNoise().data() + first;
  noisy.features = {r.features.reflectance.data() + first, r.features.normal.data() + first,
                    r.features.facing.data() + first, r.features.distance.data() + first};
  if (!r.features.noiseless.empty()) noisy.features.noiseless = r.features.noiseless.data() + first;
  if (!r.features.coverage.empty()) noisy.features.coverage = r.features.coverage.data() + first;
  if (!r.features.spread.empty()) noisy.features.spread = r.features.spread.data() + first;
  noisy.backdrop = r.features.backdrop;
  return noisy;
}

void writeChannel(const Refinement& r, float v, size_t at, size_t channel, Image& out) {
  if (out.has(Plane::wideColor)) return void(out.wideColor[4 * at + channel] = v);
  const size_t shift = 8 * channel;
  out.color[at] = (out.color[at] & ~(255u << shift)) | r.byteOf(v) << shift;
}

enum class Writes { all, alpha };

void writeTile(const Refinement& r, const WaveletTile& tile, const float* smooth, size_t first, Writes writes,
               Image& out) {
  const int width = std::min(WaveletTile::kSize, out.width - tile.x),
            height = std::min(WaveletTile::kSize, out.height - tile.y);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t i = first + static_cast<size_t>(tile.y + y) * static_cast<size_t>(out.width) +
                       static_cast<size_t>(tile.x + x);
      if (out.depth[i] == Image::kMiss) continue;
      const float* const pixel = smooth + 4 * (y * WaveletTile::kSize + x);
      for (size_t c = writes == Writes::all ? 0 : 3; c < 4; ++c) writeChannel(r, pixel[c], i, c, out);
    }
  }
}

struct Memory {
  std::vector<float> planes = std::vector<float>(render::waveletFloats());
  std::vector<float> out = std::vector<float>(size_t{4} * WaveletTile::kSize * WaveletTile::kSize);
};

void smooth(const Refinement& r, const render::NoisyImage& noisy, size_t first, Writes writes, Image& out) {
  const int columns = (out.width + WaveletTile::kSize - 1) / WaveletTile::kSize,
            rows = (out.height + WaveletTile::kSize - 1) / WaveletTile::kSize;
  tbb::enumerable_thread_specific<Memory> memories;
  tbb::parallel_for(0, columns * rows, [&](int index) {
    const render::FloatGuard guard;
    Memory& memory = memories.local();
    const WaveletTile tile{index % columns * WaveletTile::kSize, index / columns * WaveletTile::kSize};
    if (render::smoothTile(noisy, tile, memory.planes.data(), memory.out.data()))
      writeTile(r, tile, memory.out.data(), first, writes, out);
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
    for (size_t c = 0; c < 3; ++c)
      writeChannel(refinement, mean[c] + share * (colors[3 * i + c] - mean[c]), first + i, c, out);
  }
  return true;
}

/// Why images of the snapshot are not denoised; null: nothing stands against it.
const char* reasonAgainst(const scene::Snapshot& s) {
  const Settings& settings = s.settings;
  if (settings.look == Look::honest) return "look = honest shows surfaces without effects of light";
  if (settings.look == Look::noise) return "look = noise shows the noise that images have before";
  if (!scene::wantsLight(settings)) return "no effect of light is on, so images have no noise";
  if (!(settings.noise > 0)) return "with noise = 0 an image is a single pass, which is not filtered";
  if (s.layers && s.layers->of == scene::Layers::Of::drawn)
    return "translucent surfaces that are blended in the order of drawing keep their noise";
  if (!isFilterable(s)) return "an image is too large: its features would take more than 1 GiB";
  return nullptr;
}

}  // namespace

bool isDenoised(const scene::Snapshot& s) { return s.settings.denoise != Denoise::off && !reasonAgainst(s); }

void logUndenoised(const scene::Snapshot& s) noexcept {
  // `auto` promises nothing.
  if (s.settings.denoise == Denoise::off || s.settings.denoise == Denoise::automatic) return;
  try {
    if (const char* const why = reasonAgainst(s))
      log::once(log::Level::warning, why, std::string("denoise has no effect: ") + why);
  } catch (const std::exception&) {}
}

bool wantsOidn(const Refinement& refinement, const Settings& settings) {
  if (settings.denoise != Denoise::automatic) return settings.denoise == Denoise::oidn;
  // The filter knows which pixels mix surfaces and samples.
  if (!isFinished(refinement, settings) || !refinement.features.coverage.empty()) return false;
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
      const bool library = wantsOidn(refinement, settings);
      for (size_t first = 0; first < out.depth.size(); first += pixels) {
        const bool done = library && smoothByLibrary(refinement, settings, first, out);
        if (done && !refinement.features.catcher) continue;
        smooth(refinement, planeOf(refinement, out, first, settings.noise), first,
               done ? Writes::alpha : Writes::all, out);
      }
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
