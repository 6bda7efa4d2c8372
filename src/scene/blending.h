// Blending of a fragment's colour with the framebuffer's (GL 2.1, 4.1.8). Plain data.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::scene {

/// Values equal OpenGL's enumerants.
enum class BlendFactor : uint16_t {
  zero = 0,
  one = 1,
  sourceColor = 0x0300,
  oneMinusSourceColor = 0x0301,
  sourceAlpha = 0x0302,
  oneMinusSourceAlpha = 0x0303,
  destinationAlpha = 0x0304,
  oneMinusDestinationAlpha = 0x0305,
  destinationColor = 0x0306,
  oneMinusDestinationColor = 0x0307,
  sourceAlphaSaturate = 0x0308,
  constantColor = 0x8001,
  oneMinusConstantColor = 0x8002,
  constantAlpha = 0x8003,
  oneMinusConstantAlpha = 0x8004,
};

/// Values equal OpenGL's enumerants.
enum class BlendEquation : uint16_t {
  add = 0x8006,
  min = 0x8007,
  max = 0x8008,
  subtract = 0x800A,
  reverseSubtract = 0x800B,
};

struct Blending {
  /// The function of red, green and blue, or of alpha.
  struct Part {
    BlendEquation equation = BlendEquation::add;
    BlendFactor source = BlendFactor::one, destination = BlendFactor::zero;
    bool operator==(const Part&) const = default;
  };
  Part rgb, alpha;
  glm::vec4 constant{0};
  bool hasAlpha = true;     // the framebuffer has alpha; otherwise its alpha is 1
  bool writesDepth = true;  // glDepthMask
  bool operator==(const Blending&) const = default;
};

}  // namespace gluray::scene
