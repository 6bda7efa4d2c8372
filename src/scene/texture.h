// A texture image and the parameters of the unit that samples it. Immutable; a re-upload makes a new image.
#pragma once
#include "scene/texture_unit.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

enum class TextureTarget : uint8_t { texture1D, texture2D, texture3D, cubeMap, rectangle };
enum class Wrap : uint8_t {
  repeat,
  clamp,
  clampToEdge,
  clampToBorder,
  mirroredRepeat,
  mirrorClamp,  // mirrored once about 0, then clamped in one of the three ways
  mirrorClampToEdge,
  mirrorClampToBorder
};
enum class Filter : uint8_t { nearest, linear };
enum class MipFilter : uint8_t { none, nearest, linear };
/// Base internal format (GL 2.1 table 3.15): the texture environment depends on it.
enum class BaseFormat : uint8_t { alpha, luminance, luminanceAlpha, intensity, rgb, rgba };

/// The real OpenGL's method of computing the level of detail.
enum class LodRule : uint8_t {
  specified,  // GL 2.1, 3.8.8, with the exact scale factor
  llvmpipe,   // the same, with log2 of the squared scale factor interpolated linearly between powers of two
};

/// Texels, bottom row first, lowest slice first, expanded to RGBA as in GL 2.1, 3.8.1 (luminance: L,L,L,1;
/// alpha: 0,0,0,A; intensity: I,I,I,I). 1D textures have height 1; the slices of cube maps are the faces +x,
/// -x, +y, -y, +z, -z.
struct TexelGrid {
  int width = 0, height = 0, depth = 1;
  std::vector<uint32_t> texels;   // RGBA8, red in the lowest byte, width*height*depth; or
  std::vector<glm::vec4> floats;  // as many, if eight bits lack the range or precision
};

/// The base level and, for mipmapping, the smaller levels up to the last that may be sampled.
struct TextureImage : TexelGrid {
  BaseFormat baseFormat = BaseFormat::rgba;
  bool opaque = true;      // every alpha of every level is 1
  bool normalised = true;  // every component of every level lies in 0 .. 1
  std::vector<TexelGrid> mipmaps;

  int levels() const { return static_cast<int>(mipmaps.size()) + 1; }
  const TexelGrid& level(int i) const { return i == 0 ? *this : mipmaps[static_cast<size_t>(i - 1)]; }
};

/// An image with its sampling parameters and texture environment.
struct Texture {
  std::shared_ptr<const TextureImage> image;
  TextureTarget target = TextureTarget::texture2D;
  uint8_t unit = 0;  // texture unit, 0 .. 7; also the number of its coordinate set
  Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat, wrapR = Wrap::repeat;
  bool seamless = false;  // cube maps: linear filters blend texels of adjacent faces
  Filter magFilter = Filter::linear, minFilter = Filter::linear;
  MipFilter mipFilter = MipFilter::none;  // between levels, where the image is minified
  LodRule lodRule = LodRule::specified;
  float lodBias = 0;  // sum of the unit's and the texture's
  float minLod = -1000, maxLod = 1000;
  float maxAnisotropy = 1;  // above 1: of two-dimensional textures, as llvmpipe filters them
  bool byteFilter = false;  // filters of texels with eight bits round to eight bits, as llvmpipe's do
  glm::vec4 borderColor{0};
  TexEnv env = TexEnv::modulate;
  Combine combine;  // where env is TexEnv::combine
  glm::vec4 envColor{0};
  TexGen texGen;
  glm::mat4 textureMatrix{1};  // applied to (s, t, r, q)
  bool operator==(const Texture&) const = default;
};

}  // namespace gluray::scene
