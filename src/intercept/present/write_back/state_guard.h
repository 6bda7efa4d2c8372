// Sets state of the real OpenGL for drawing of our own, and puts back everything it changed when it dies,
// newest first. It asks before it sets, so that state which already suits us costs one query. GL thread,
// context current, outside glBegin/glEnd and outside list compilation.
#pragma once
#include "intercept/present/features.h"
#include "scene/snapshot.h"

#include <array>
#include <vector>

namespace gluray::present {

/// Errors that the program has caused and not yet fetched. A guard's owner hands them back to be reported
/// later.
using PendingErrors = std::vector<GLenum>;

/// Empties the real OpenGL's error flags. At most 16 are read, in case a lost context repeats one for ever.
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

  /// No test, operation or mask other than depth stands between a fragment and every draw buffer: blending,
  /// stencil, alpha test, logic operation, stipple, clip planes, culling, rasterizer discard and coverage are
  /// off, masks are open. Depth test, viewport and scissor are the caller's to set. sRGB encoding and
  /// dithering stay as the program has them.
  void openFragmentPath();
  /// The open path into the region of a snapshot: its viewport, depth range and multisampling, depth test
  /// `func`.
  void drawInto(const scene::Snapshot& snapshot, GLenum func);
  void depthTest(GLenum func);  // test on, writes on
  /// Colours are blended with what is there as gl::addsUp has it. After openFragmentPath().
  void addUp();
  /// The same for colours that were multiplied with what they cover, their alpha.
  void blendOver();
  void colorWrites(const scene::ColorWrites& on);  // to all draw buffers; after openFragmentPath()
  void encoding(bool on);                          // GL_FRAMEBUFFER_SRGB
  void depthWrites(bool on);
  void depthRange(double zNear, double zFar);
  /// GL_POLYGON_OFFSET_FILL is on, without a clamp.
  void polygonOffset(float factor, float units);
  void viewport(int x, int y, int width, int height);
  void scissor(int x, int y, int width, int height);
  void scissorOff();

  /// Pixel uploads from client memory, values as they are, rows `rowLength` pixels apart (0: tightly packed).
  void plainUnpack(int rowLength = 0);
  /// Pixels read into client memory, values as they are, tightly packed.
  void plainPack();
  /// Draws go to the window's `buffer`.
  void drawToWindow(GLenum buffer);
  /// Reads come from `buffer` of `framebuffer`.
  void readFrom(GLuint framebuffer, GLenum buffer);
  void activeTexture(GLenum unit);
  void texture2D(int unit, GLuint texture);  // also makes `unit` active and frees it of sampler objects
  void textureMultisample(int unit, GLuint texture);
  void program(GLuint program);  // transform feedback is paused meanwhile
  void vertexArray(GLuint array);
  void lastVertexProvokes();
  /// Only sample `sample` is written; may be called again for the next sample.
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
  void blendEquation(GLuint buffer);
  void blendFactors(GLuint buffer, const std::array<GLint, 4>& wanted);
  void blend(int drawBuffers, const std::array<GLint, 4>& factors);  // source, target; of RGB, of alpha
  void colorMasks();
  void coverage();
  void keep(const Undo& undo) { log_.push_back(undo); }

  const gl::RealGl& real_;
  const Features& features_;
  std::vector<Undo> log_;
};

}  // namespace gluray::present
