// A texture image as the fixed-function pipeline samples it. Immutable; a re-upload makes a new one.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

enum class Wrap : uint8_t { repeat, clamp, clampToEdge, clampToBorder, mirroredRepeat };
enum class Filter : uint8_t { nearest, linear };
/// GL 2.1 table 3.15: which channels a texture has decides what the environment does with them.
enum class BaseFormat : uint8_t { alpha, luminance, luminanceAlpha, intensity, rgb, rgba };
enum class TexEnv : uint8_t { modulate, replace, decal, blend, add };

/// Texels, lowest row first, already expanded to RGBA as GL 2.1 section 3.8.1 says
/// (luminance: L,L,L,1; alpha: 0,0,0,A; intensity: I,I,I,I). 1D textures have height 1.
struct TextureImage {
  int width = 0, height = 0;
  BaseFormat baseFormat = BaseFormat::rgba;
  std::vector<uint32_t> texels;  // RGBA8, red in the lowest byte, width*height
  bool opaque = true;            // every alpha is 255
};

/// An image with the way it is sampled and combined with the fragment's colour.
struct Texture {
  std::shared_ptr<const TextureImage> image;
  int dimensions = 2;  // 1 or 2
  Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat;
  Filter magFilter = Filter::linear, minFilter = Filter::linear;  // mipmapped minification is not traced
  glm::vec4 borderColor{0};
  TexEnv env = TexEnv::modulate;
  glm::vec4 envColor{0};
  glm::mat4 textureMatrix{1};  // applied to (s, t, r, q)
  bool operator==(const Texture&) const = default;
};

}  // namespace gluray::scene
