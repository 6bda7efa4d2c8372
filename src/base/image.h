// A traced image: planes of colour, depth and more for a rectangle of the framebuffer. Made by render/,
// read by frame/ and intercept/present. Plain data.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray {

/// Histogram of composited transparent layers: element n >= 2 counts the pixels with n layers; the last
/// element also counts those with more. Invisible layers are excluded unless only some are peeled
/// (scene::Layers::peels).
struct LayerCounts {
  static constexpr size_t kMax = 64;
  std::array<uint32_t, kMax> open{};    // pixels without an opaque surface behind the layers
  std::array<uint32_t, kMax> before{};  // pixels with an opaque surface behind them
};

/// Values that an image may hold per pixel, or per sample of a multisampled framebuffer.
enum class Plane : uint8_t {
  color = 1,          // RGBA8
  wideColor = 2,      // RGBA floats, not clamped to [0, 1]
  depth = 4,          // window depth
  transmittance = 8,  // product of 1 - opacity over all fragments
  centerDepth = 16,   // window depth at the pixel's centre, if pixels are averages
};

/// A set of planes.
class Planes {
 public:
  constexpr Planes() = default;
  constexpr Planes(Plane plane) : bits_(static_cast<uint8_t>(plane)) {}  // NOLINT: one plane is a set
  constexpr bool has(Plane plane) const { return bits_ & static_cast<uint8_t>(plane); }
  constexpr friend Planes operator|(Planes a, Planes b) {
    a.bits_ |= b.bits_;
    return a;
  }
  constexpr bool operator==(const Planes&) const = default;

 private:
  uint8_t bits_ = 0;
};
constexpr Planes operator|(Plane a, Plane b) { return Planes(a) | Planes(b); }

/// Planes of `width` x `height` pixels, bottom row first, as in OpenGL. With several samples per pixel, each
/// plane stores the first samples of all pixels, then all second samples, and so on.
struct Image {
  static constexpr float kMiss = 2.0f;  // depth of a pixel that no ray hit
  static constexpr Planes kColorDepth = Plane::color | Plane::depth;
  static constexpr Planes kWide = Plane::wideColor | Plane::depth;
  /// Sums over all fragments: colour times opacity and, in alpha, opacity.
  static constexpr Planes kSums = kWide | Plane::transmittance;

  int x = 0, y = 0;                  // window coordinates of the lower left pixel
  int width = 0, height = 0;         // pixels
  int samples = 1;                   // per pixel, of a multisampled framebuffer
  Planes planes = kColorDepth;       // the others are empty
  std::vector<uint32_t> color;       // red in the lowest byte
  std::vector<float> wideColor;      // four per pixel
  std::vector<float> depth;          // in [0, 1]; kMiss for misses
  std::vector<float> transmittance;  // 1 for misses
  /// Depth at the pixel's centre, if pixels are averages over several rays. (In averages, misses count as 0
  /// in all channels.) `depth` is equal to it or, if the ray at the centre missed, to the depth of the
  /// nearest ray.
  std::vector<float> centerDepth;
  uint32_t missColor = 0;  // value of misses in `color`; set before tracing. 0 for averages
  LayerCounts layers;

  bool has(Plane plane) const { return planes.has(plane); }
  /// Whether pixels are averages over several rays.
  bool isAverages() const { return has(Plane::centerDepth); }
  /// Whether each pixel has one RGBA8 colour and one depth, from one ray.
  bool isPlain() const { return planes == kColorDepth && samples == 1; }

  /// Memory of the planes in bytes.
  size_t bytes() const {
    return 4 * (color.capacity() + depth.capacity() + wideColor.capacity() + transmittance.capacity() +
                centerDepth.capacity());
  }

  /// Allocates planes of this shape and reuses memory. Afterwards their contents are undefined.
  void resize(int newWidth, int newHeight, int newSamples, Planes newPlanes = kColorDepth) {
    width = newWidth, height = newHeight, samples = newSamples, planes = newPlanes;
    const auto count =
        static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(samples);
    const auto sizeOf = [&](Plane plane) { return has(plane) ? count : 0; };
    color.resize(sizeOf(Plane::color));
    depth.resize(sizeOf(Plane::depth));
    wideColor.resize(4 * sizeOf(Plane::wideColor));
    transmittance.resize(sizeOf(Plane::transmittance));
    centerDepth.resize(sizeOf(Plane::centerDepth));
  }
};

}  // namespace gluray
