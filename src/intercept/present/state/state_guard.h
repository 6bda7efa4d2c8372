// Sets the real OpenGL's state for our own drawing; the destructor restores everything it changed, newest
// first. Queries state before setting it, so that state which is right already costs one query. GL thread,
// context current, outside glBegin/glEnd and outside list compilation.
#pragma once
#include "gl/real/other_program.h"
#include "intercept/present/state/features.h"
#include "scene/snapshot.h"

#include <array>
#include <optional>
#include <vector>

namespace gluray::present {

/// Errors that the program has caused and not yet fetched. The guard's owner returns them to be reported
/// later.
using PendingErrors = std::vector<GLenum>;

/// Fetches the real OpenGL's errors: at most 16, because a lost context may repeat one for ever.
PendingErrors takeErrors(const gl::RealGl& real);

class StateGuard {
 public:
  StateGuard(const gl::RealGl& real, const Features& features);
  ~StateGuard();
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

  /// glEnable or glDisable.
  void capability(GLenum name, bool on);
  /// The same for one index (draw buffer or viewport).
  void capability(GLenum name, GLuint index, bool on);

  /// Disables all fragment tests, operations and masks other than depth, for every draw buffer: blending,
  /// stencil, alpha test, logic operation, stipple, clip planes, culling, rasterizer discard, coverage, write
  /// masks. The caller sets depth test, viewport and scissor. Keeps the program's sRGB encoding and
  /// dithering.
  void openFragmentPath();
  /// openFragmentPath() for the region of a snapshot: sets its viewport, depth range and multisampling, and
  /// depth test `func`.
  void drawInto(const scene::Snapshot& snapshot, GLenum func);
  void depthTest(GLenum func);  // enables test and writes
  /// Sets the blending of layer sums, as in gl::addsUp: adds RGB, multiplies alpha. After openFragmentPath().
  void addUp();
  /// Sets the blending and the depth mask of layers that are blended in the order of drawing, into one draw
  /// buffer. After openFragmentPath() and depthTest().
  void blendAs(const scene::Blending& blending);
  /// Sets "over" blending for premultiplied colours. After openFragmentPath().
  void blendOver();
  /// The same for colours that are not. After openFragmentPath().
  void blendByAlpha();
  void colorWrites(const scene::ColorWrites& on);  // to all draw buffers; after openFragmentPath()
  void encoding(bool on);                          // GL_FRAMEBUFFER_SRGB
  void depthWrites(bool on);
  void depthRange(double zNear, double zFar);
  /// Clip space with the origin at the lower left, and depths from 0 or from -1.
  void clipSpace(bool depthsFromZero);
  /// Enables GL_POLYGON_OFFSET_FILL, without a clamp.
  void polygonOffset(float factor, float units);
  void viewport(int x, int y, int width, int height);
  void scissor(int x, int y, int width, int height);
  void scissorOff();

  /// Pixel uploads from client memory, unconverted, rows `rowLength` pixels apart (0: tightly packed).
  void plainUnpack(int rowLength = 0);
  /// Pixel reads into client memory, unconverted, tightly packed.
  void plainPack();
  /// Draws go to the window's `buffer`.
  void drawToWindow(GLenum buffer);
  /// Reads come from `buffer` of `framebuffer`.
  void readFrom(GLuint framebuffer, GLenum buffer);
  void activeTexture(GLenum unit);
  void texture2D(int unit, GLuint texture);  // also activates `unit` and unbinds its sampler object
  void textureMultisample(int unit, GLuint texture);
  void program(GLuint program);  // also pauses transform feedback
  void vertexArray(GLuint array);
  void lastVertexProvokes();
  /// Writes only sample `sample`; may be called again for the next sample.
  void onlySample(int sample);

 private:
  struct Undo {
    void (*restore)(const gl::RealGl&, const Undo&);
    GLenum name = 0;
    GLuint index = 0;
    std::array<GLint, 4> i{};
    std::array<GLdouble, 4> d{};
  };
  GLint integer(GLenum name) const;
  void pixelStore(GLenum name, GLint value);
  void pixelTransfer(GLenum name, GLfloat value);
  void plainTransfer();
  void texture(int unit, GLenum target, GLenum binding, GLuint texture);
  void unbindBuffer(GLenum target, GLenum binding);
  GLint ofDrawBuffer(GLenum name, GLuint buffer) const;
  void blendEquation(GLuint buffer, GLenum rgb, GLenum alpha);
  void blendConstant(const glm::vec4& color);
  void blendFactors(GLuint buffer, const std::array<GLint, 4>& wanted);
  void blend(int drawBuffers, const std::array<GLint, 4>& factors);  // source, target; of RGB, of alpha
  void colorMasks();
  void coverage();
  void keep(const Undo& undo) { log_.push_back(undo); }

  const gl::RealGl& real_;
  const Features& features_;
  std::vector<Undo> log_;
  std::optional<gl::OtherProgram> program_;
};

}  // namespace gluray::present
