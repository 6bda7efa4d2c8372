// State of a texture unit without its texture: environment and coordinate generation. Plain data.
#pragma once
#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace gluray::scene {

constexpr int kTextureUnits = 8;  // units of the fixed-function pipeline that are traced

enum class TexEnv : uint8_t { modulate, replace, decal, blend, add, combine };

/// GL_COMBINE: GL 2.1, tables 3.24 to 3.26.
struct Combine {
  enum Function : uint8_t {
    replace,
    modulate,
    add,
    addSigned,
    interpolate,
    subtract,
    dot3Rgb,   // colours only
    dot3Rgba,  // the same; the result also becomes alpha
  };
  /// `texture` is the unit's own texture; textureUnit + n is that of unit n.
  enum Source : uint8_t { texture, constant, primary, previous, textureUnit };
  enum Operand : uint8_t { color, oneMinusColor, alpha, oneMinusAlpha };
  struct Argument {
    uint8_t source = texture;
    Operand operand = color;
    bool operator==(const Argument&) const = default;
  };
  struct Part {
    Function function = modulate;
    std::array<Argument, 3> arguments;
    float scale = 1;  // 1, 2 or 4
    bool operator==(const Part&) const = default;
  };
  Part rgb, alphaPart;
  bool operator==(const Combine&) const = default;
};

/// glTexGen: GL 2.1, 2.11.4. Coordinates that are not generated come from the vertex.
struct TexGen {
  enum Mode : uint8_t { off, objectLinear, eyeLinear, sphereMap, normalMap, reflectionMap };
  struct Coordinate {
    Mode mode = off;
    glm::vec4 plane{0};  // of objectLinear: in object space; of eyeLinear: in eye space
    bool operator==(const Coordinate&) const = default;
  };
  std::array<Coordinate, 4> coordinates;  // s, t, r, q
  bool operator==(const TexGen&) const = default;

  bool on() const {
    for (const Coordinate& c : coordinates)
      if (c.mode != off) return true;
    return false;
  }
};

}  // namespace gluray::scene
