// Writes a traced image, colour and depth, into the framebuffer that the program has bound. One per
// context. GL thread, context current, outside glBegin/glEnd, GL_RENDER mode, and before any query,
// conditional rendering or transform feedback starts that the program's own draws were not part of.
#pragma once
#include "base/image.h"
#include "frame/pixels/hit_bands.h"
#include "gl/batch/presenter.h"
#include "intercept/present/state/state_guard.h"
#include "intercept/present/write_back/taken_light.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace gluray::present {

/// Parameters of a write, besides the image's own rectangle.
struct WriteBackTarget {
  GLenum depthFunc = GL_LEQUAL;  // depth test of traced pixels against the framebuffer
  uint64_t imageId = 0;          // id of the image: an equal id is not uploaded again; 0: it has none
  GLenum over = 0;  // write into this buffer of the window instead, without depth test; keeps its depth
  bool colors = true, depths = true;    // planes to write; without depths there is no depth test
  bool keepsDepth = false;              // blended over the framebuffer, whose depth is tested and stays
  bool asProgram = false;               // as the program has set blending and the depth mask
  bool replaces = false;                // with keepsDepth: not blended
  scene::ColorWrites colorWrites = {};  // colour channels to write
  std::optional<bool> encodes = {};     // GL_FRAMEBUFFER_SRGB; null: the program's setting
};

class WriteBack {
 public:
  /// Kinds of colour planes of images.
  enum class Colors : uint8_t { bytes, floats, sums, taken };
  static constexpr size_t kKinds = 4;
  static Colors colorsOf(const Image& image) {
    if (image.has(Plane::transmittance)) return Colors::sums;
    return image.has(Plane::wideColor) ? Colors::floats : Colors::bytes;
  }

  /// Writes only images with such colours; Colors::taken: TakenLight.
  explicit WriteBack(const gl::RealGl& real, Colors colors = Colors::bytes) : real_(real), colors_(colors) {}

  /// Compiles the program on first use. False, with the reason, if the context cannot; the result never
  /// changes.
  bool ready(std::string& why);

  /// Writes every hit pixel (sample, if image.samples > 1) that passes the depth test to all draw buffers, in
  /// one pass over the image's rectangle. Keeps pixels of misses. Depths are window depths, including
  /// glDepthRange. Averages over samples (Image::centerDepth) are blended over the framebuffer, with coverage
  /// as alpha, and write their centres' depth. Sums ignore and keep depth; blending as in gl::addsUp adds
  /// them to the first two draw buffers: premultiplied colours and transmittance to the first, opacities to
  /// the second's red. Restores all queryable state; moves pending errors to `pending`. False, with nothing
  /// drawn or an image to be drawn again, if the real OpenGL refuses.
  bool write(const Image& image, const WriteBackTarget& target, PendingErrors& pending);

  /// Blends black with these opacities over the framebuffer, in all draw buffers, without a depth test.
  /// Restores state and returns as write() does. Of Colors::taken alone.
  bool writeTaken(const TakenLight& taken, const WriteBackTarget& target, PendingErrors& pending);

  /// Releases ownership of our names in the share group, and returns them.
  gl::SharedNames takeNames();
  /// Deletes our objects; otherwise they live as long as the share group.
  void release();

 private:
  /// A texture that several viewports of one frame share, see grownSize().
  struct PlaneTexture {
    GLuint texture = 0;
    glm::ivec2 size = {0, 0};  // texels
  };
  bool compile(std::string& why);
  bool makePlane(StateGuard& guard, int unit, PlaneTexture& plane, GLenum internalFormat, GLenum format,
                 GLenum type, int width, int height);
  /// One sample plane of the image: its bands of hits, and its first row in the textures.
  struct Sheet {
    int sample = 0, row = 0;
    std::vector<frame::Band> bands;
  };
  void findSheets(const Image& image, int planes);
  bool writeInto(StateGuard& guard, const Image& image, const WriteBackTarget& target, int planes);
  enum class Part { all, colors, depths };
  void upload(const Image& image, const Sheet& sheet, Part part) const;
  void openFor(StateGuard& guard, const WriteBackTarget& target) const;
  void writeAverages(StateGuard& guard, const Image& image, const Sheet& sheet,
                     const WriteBackTarget& target) const;
  /// `width` x `height`: of the image, whose lower left pixel is at `at` in the window.
  void draw(glm::ivec2 at, int width, int height, const Sheet& sheet) const;
  void draw(const Image& image, const Sheet& sheet) const {
    draw({image.x, image.y}, image.width, image.height, sheet);
  }
  bool uploadTaken(StateGuard& guard, const TakenLight& taken);
  void useProgram(StateGuard& guard);

  const gl::RealGl& real_;
  const Colors colors_;
  Features features_;
  enum class State { unknown, ready, impossible } state_ = State::unknown;
  std::string why_;
  /// Two equal programs, used alternately: Mesa (22.3, llvmpipe) reuses a program's earlier texture state if
  /// nothing else was drawn since, but loses that state if the framebuffer was read or resized meanwhile.
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
  uint64_t held_ = 0;          // id of the image that the textures hold; 0: none or an incomplete one
};

}  // namespace gluray::present
