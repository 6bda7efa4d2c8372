// Writes a traced picture, colour and depth, into the framebuffer that the program has bound. One per
// context. GL thread, context current, outside glBegin/glEnd, GL_RENDER mode, and before any query,
// conditional rendering or transform feedback starts that the program's own draws were not part of.
#pragma once
#include "base/image.h"
#include "frame/hit_bands.h"
#include "gl/batch/presenter.h"
#include "intercept/present/write_back/state_guard.h"

#include <array>
#include <optional>
#include <string>

namespace gluray::present {

/// What the write must respect besides the image's own rectangle.
struct WriteBackTarget {
  GLenum depthFunc = GL_LEQUAL;  // how traced pixels meet the depth that is there
  uint64_t picture = 0;  // number of the image: the same as last time is not sent again; 0: it has none
  GLenum over = 0;       // into this buffer of the window instead, over everything there; its depth stays
  bool colors = true, depths = true;    // what is written; without depths none is tested
  scene::ColorWrites colorWrites = {};  // of the colours
  std::optional<bool> encodes = {};     // GL_FRAMEBUFFER_SRGB; null: as the program has it
};

class WriteBack {
 public:
  /// How images hold their colours.
  enum class Colors : uint8_t { bytes, floats, sums };
  static Colors colorsOf(const Image& image) {
    if (image.has(Plane::transmittance)) return Colors::sums;
    return image.has(Plane::wideColor) ? Colors::floats : Colors::bytes;
  }

  /// Writes images with such colours alone.
  explicit WriteBack(const gl::RealGl& real, Colors colors = Colors::bytes) : real_(real), colors_(colors) {}

  /// Compiles the program on first use. False, with the reason, where the context cannot do it; the answer
  /// never changes.
  bool ready(std::string& why);

  /// Writes every hit pixel (sample, where image.samples > 1) that passes the depth test, in one go over the
  /// image's rectangle, to all draw buffers. Misses stay untouched. Depth values are window depths:
  /// glDepthRange is in them. Averages over samples (Image::centerDepth) are blended over what is there,
  /// their alpha being what they cover, and leave the depth of their centres. Sums are added to the first two
  /// draw buffers instead, whatever the depth there, which stays: colours times opacity and what is let
  /// through to the first's, opacities to the second's red, by blending as gl::addsUp has it. No state that
  /// the program can query differs afterwards; errors that were pending are moved to `pending`. False, with
  /// nothing drawn or a picture to be drawn again, where the real OpenGL refuses.
  bool write(const Image& image, const WriteBackTarget& target, PendingErrors& pending);

  /// Names of what lives in the share group, which are no longer ours.
  gl::SharedNames takeNames();
  /// Deletes our objects. Without this they live as long as the share group.
  void release();

 private:
  /// A texture that grows and never shrinks, so that several viewports of one frame share it.
  struct PlaneTexture {
    GLuint texture = 0;
    int width = 0, height = 0;  // texels
  };
  bool compile(std::string& why);
  bool makePlane(StateGuard& guard, int unit, PlaneTexture& plane, GLenum internalFormat, GLenum format,
                 GLenum type, int width, int height);
  GLuint newTextureName() const;
  /// One sample plane of the image: what of it was hit, and at which row of the textures it lies.
  struct Sheet {
    int sample = 0, row = 0;
    std::vector<frame::Band> bands;
  };
  void findSheets(const Image& image, int planes);
  bool writeInto(StateGuard& guard, const Image& image, const WriteBackTarget& target, int planes);
  enum class Part { all, colors, depths };
  void upload(const Image& image, const Sheet& sheet, Part part) const;
  void openFor(StateGuard& guard, const WriteBackTarget& target) const;
  void writeAverages(StateGuard& guard, const Image& image, const Sheet& sheet) const;
  void draw(const Image& image, const Sheet& sheet) const;

  const gl::RealGl& real_;
  const Colors colors_;
  Features features_;
  enum class State { unknown, ready, impossible } state_ = State::unknown;
  std::string why_;
  /// Two equal programs, used in turn: Mesa (22.3, llvmpipe) goes on with what a program sampled before if
  /// nothing else was drawn since, and has lost that where the framebuffer was read or resized meanwhile.
  struct Program {
    GLuint name = 0;
    GLint place = -1, bands = -1;  // uniforms
  };
  std::array<Program, 2> programs_;
  bool compile(Program& program, std::string& why) const;
  GLuint vertexArray_ = 0;
  GLenum depthInternalFormat_ = 0, depthFormat_ = 0;
  PlaneTexture color_, depth_;
  std::vector<Sheet> sheets_;  // of the last image
  uint64_t held_ = 0;          // number of the image that the textures hold; 0: none, or not all of one
};

}  // namespace gluray::present
