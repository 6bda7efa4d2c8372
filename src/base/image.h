// A traced picture: planes of colour, depth and more of a rectangle of the framebuffer. Made by render/,
// read by frame/ and intercept/present.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray {

/// Of surfaces that are seen through, composited: how many pixels have n >= 2 layers one behind the other.
/// Those that are not seen any more are left out, but where only some are peeled (scene::Layers::peels). The
/// last number stands for all that are larger.
struct LayerCounts {
  static constexpr size_t kMost = 64;
  std::array<uint32_t, kMost> open{};    // pixels with nothing opaque behind the layers
  std::array<uint32_t, kMost> before{};  // pixels with something opaque behind them
};

/// What an image may hold of each pixel, or of each sample of a multisampled framebuffer.
enum class Plane : uint8_t {
  color = 1,          // RGBA8
  wideColor = 2,      // RGBA floats, beyond [0, 1] if they are so
  depth = 4,          // window depth
  transmittance = 8,  // product of what all fragments let through, 1 - opacity
  centerDepth = 16,   // window depth at the pixel's centre, where pixels are averages over several rays
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

/// Planes of `width` x `height` pixels, bottom row first, as OpenGL has them. With several samples a pixel
/// the planes of further samples follow the first.
struct Image {
  static constexpr float kMiss = 2.0f;  // depth of a pixel that no ray hit
  static constexpr Planes kPicture = Plane::color | Plane::depth;
  static constexpr Planes kWide = Plane::wideColor | Plane::depth;
  /// Sums over all fragments of colour times opacity, and of opacities in alpha.
  static constexpr Planes kSums = kWide | Plane::transmittance;

  int x = 0, y = 0;                  // window coordinates of the lower left pixel
  int width = 0, height = 0;         // pixels
  int samples = 1;                   // a pixel, of a multisampled framebuffer
  Planes planes = kPicture;          // the others are empty
  std::vector<uint32_t> color;       // red in the lowest byte
  std::vector<float> wideColor;      // four a pixel
  std::vector<float> depth;          // in [0, 1], kMiss where nothing was hit
  std::vector<float> transmittance;  // 1 where nothing was hit
  /// Where pixels are averages over several rays, misses being 0 in all channels: the depth at their centres.
  /// `depth` is the same, or where the centre missed that of the nearest ray.
  std::vector<float> centerDepth;
  uint32_t missColor = 0;  // what misses have in `color`; set before tracing. Of averages: 0
  LayerCounts layers;

  bool has(Plane plane) const { return planes.has(plane); }
  /// Whether pixels are averages over several rays.
  bool isAverages() const { return has(Plane::centerDepth); }
  /// Whether it is one RGBA8 colour and one depth a pixel, each of one ray.
  bool isPlain() const { return planes == kPicture && samples == 1; }

  /// What the planes take.
  size_t bytes() const {
    return 4 * (color.capacity() + depth.capacity() + wideColor.capacity() + transmittance.capacity() +
                centerDepth.capacity());
  }

  /// Makes room for the given shape, reusing memory. Contents are undefined afterwards.
  void resize(int newWidth, int newHeight, int newSamples, Planes newPlanes = kPicture) {
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
