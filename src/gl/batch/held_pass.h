// Render passes whose draws are held back because their result is traced. Owned by HeldPeels, GL thread.
#pragma once
#include "gl/batch/program_draw.h"
#include "gl/clock/image_wish.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::gl {

/// The draws of a pass, and the state that the real OpenGL needs to replay them, without depth test.
struct HeldPass {
  struct Output {
    GLuint texture = 0;  // GL_TEXTURE_2D; 0: the draw buffer is GL_NONE
    GLint level = 0;
    bool operator==(const Output&) const = default;
  };
  std::vector<Output> outputs;  // by draw buffer
  glm::ivec4 viewport{0};
  std::optional<glm::vec4> clear;  // colour to which all outputs are cleared first
  enum class Blend : uint8_t {
    largest,  // GL_MAX
    over,     // over the framebuffer, with premultiplied alpha
  } blend = Blend::largest;
  std::vector<ProgramDraw> draws;
};

/// The passes of a host program that peels layers (dual depth peeling), and where the result goes.
struct LayersTarget {
  HeldPass depths;                      // the depth pass: nearest and farthest depths for the peels
  HeldPass surfaces;                    // the first peel
  GLuint opaqueDepth = 0;               // texture that `depths` reads
  std::vector<glm::vec2> opaqueDepths;  // contents of that texture; green: depth of opaque surfaces, or -1
  GLuint result = 0;                    // RGBA8 texture: colour times opacity, and opacity
  glm::ivec2 size{0};                   // of all these textures
  ImageWish wish;
  bool written = false;         // `result` holds a traced image
  bool mayAsk = false;          // image and later peels may wait until the number of peels is known
  std::vector<uint32_t> image;  // traced, not yet written to `result`, the newest peel's texture
  std::vector<HeldPass> later;  // the program's clears and draws after the first peel
};

}  // namespace gluray::gl
