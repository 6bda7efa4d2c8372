// MultipassSurfaces with several outputs whose draws are held back, because all they lead to can be traced in
// one go. GL thread.
#pragma once
#include "gl/programs/program_draw.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::gl {

/// Draws, and what the real OpenGL needs to make them after all: without depth test.
struct HeldPass {
  struct Output {
    GLuint texture = 0;  // GL_TEXTURE_2D; 0: the draw buffer is GL_NONE
    GLint level = 0;
    bool operator==(const Output&) const = default;
  };
  std::vector<Output> outputs;  // by draw buffer
  glm::ivec4 viewport{0};
  std::optional<glm::vec4> clear;  // all outputs are cleared to that before
  enum class Blend : uint8_t {
    largest,  // GL_MAX
    over,     // put over what is there, multiplied with their alpha
  } blend = Blend::largest;
  std::vector<ProgramDraw> draws;
};

/// Surfaces that are seen through: the two passes of a program that composites them, and where the result
/// goes.
struct LayersTarget {
  HeldPass depths;                      // finds the nearest and farthest, for the program's own compositing
  HeldPass surfaces;                    // the first peel
  GLuint opaqueDepth = 0;               // texture that `depths` reads, and
  std::vector<glm::vec2> opaqueDepths;  // what was in it: green the depth of what is opaque, or -1
  GLuint result = 0;                    // RGBA8 texture: colours times opacity, and opacity
  glm::ivec2 size{0};                   // of all these textures
  bool mayRepeat = true;                // as PresentTarget's
  bool written = false;                 // the result holds a traced picture
  bool mayAsk =
      false;  // picture and later peels may wait until it is known how many the program draws. Then:
  std::vector<uint32_t> picture;  // traced, and not yet in `result`, which is that of the newest peel
  std::vector<HeldPass> later;    // what the program cleared and drew after the first peel
};

}  // namespace gluray::gl
