#include "intercept/present/raster/program_replay.h"

#include "gl/programs/set_uniform.h"

#include <algorithm>

namespace gluray::present {
namespace {

using gl::ProgramDraw;
using gl::RealGl;
using gl::UniformValue;

/// Saves uniform values of the program in use; the destructor restores them.
class KeptUniforms {
 public:
  KeptUniforms(const RealGl& real, GLuint program, const gl::UniformValues& names)
      : real_(real), values_(names) {
    for (UniformValue& v : values_) {
      if (v.location < 0) continue;
      if (gl::shapeOf(v.type).integers)
        real.GetUniformiv(program, v.location, v.integers.data());
      else
        real.GetUniformfv(program, v.location, v.floats.data());
    }
  }
  ~KeptUniforms() {
    for (const UniformValue& v : values_) setUniform(real_, v);
  }
  KeptUniforms(const KeptUniforms&) = delete;
  KeptUniforms& operator=(const KeptUniforms&) = delete;

 private:
  const RealGl& real_;
  gl::UniformValues values_;
};

/// Binds the textures of a draw to their units; the destructor restores the bindings.
class KeptTextures {
 public:
  KeptTextures(const RealGl& real, const ProgramDraw& draw) : real_(real) {
    real.GetIntegerv(GL_ACTIVE_TEXTURE, &active_);
    for (const ProgramDraw::BoundTexture& wanted : draw.textures) {
      GLint now = 0;
      real.ActiveTexture(GL_TEXTURE0 + wanted.unit);
      real.GetIntegerv(wanted.target.binding, &now);
      was_.push_back({wanted.unit, wanted.target, static_cast<GLuint>(now)});
      real.BindTexture(wanted.target.target, wanted.name);
    }
  }
  ~KeptTextures() {
    for (auto t = was_.rbegin(); t != was_.rend(); ++t) {
      real_.ActiveTexture(GL_TEXTURE0 + t->unit);
      real_.BindTexture(t->target.target, t->name);
    }
    real_.ActiveTexture(static_cast<GLenum>(active_));
  }
  KeptTextures(const KeptTextures&) = delete;
  KeptTextures& operator=(const KeptTextures&) = delete;

 private:
  const RealGl& real_;
  GLint active_ = GL_TEXTURE0;
  std::vector<ProgramDraw::BoundTexture> was_;
};

/// Binds buffers with the kept contents of uniform blocks; the destructor restores the bindings.
class KeptBlocks {
 public:
  KeptBlocks(const RealGl& real, const std::vector<gl::UniformBlock>& blocks) : real_(real) {
    if (blocks.empty()) return;
    real.GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &saved_);
    for (const gl::UniformBlock& block : blocks) {
      was_.push_back(gl::boundBlock(real, block.binding));
      GLuint name = 0;
      real.GenBuffers(1, &name);
      buffers_.push_back(name);
      real.BindBufferBase(GL_UNIFORM_BUFFER, block.binding, name);
      real.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(block.contents.size()),
                      block.contents.data(), GL_STREAM_DRAW);
    }
  }
  ~KeptBlocks() {
    if (buffers_.empty()) return;
    for (auto b = was_.rbegin(); b != was_.rend(); ++b) {
      if (b->buffer == 0 || b->size == 0)
        real_.BindBufferBase(GL_UNIFORM_BUFFER, b->binding, b->buffer);
      else
        real_.BindBufferRange(GL_UNIFORM_BUFFER, b->binding, b->buffer, static_cast<GLintptr>(b->start),
                              static_cast<GLsizeiptr>(b->size));
    }
    real_.BindBuffer(GL_UNIFORM_BUFFER, static_cast<GLuint>(saved_));
    real_.DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  }
  KeptBlocks(const KeptBlocks&) = delete;
  KeptBlocks& operator=(const KeptBlocks&) = delete;

 private:
  const RealGl& real_;
  GLint saved_ = 0;
  std::vector<gl::BlockBinding> was_;
  std::vector<GLuint> buffers_;
};

/// A vertex array object with copies of the draw's arrays in its own buffers.
class OwnArrays {
 public:
  OwnArrays(const RealGl& real, const ProgramDraw& draw) : real_(real) {
    real.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &savedArray_);
    real.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &savedBuffer_);
    real.GenVertexArrays(1, &array_);
    real.BindVertexArray(array_);
    for (const ProgramDraw::Array& a : draw.arrays) add(a);
    if (draw.indexContents) upload(GL_ELEMENT_ARRAY_BUFFER, *draw.indexContents);
  }
  ~OwnArrays() {
    real_.BindVertexArray(static_cast<GLuint>(savedArray_));
    real_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(savedBuffer_));
    real_.DeleteVertexArrays(1, &array_);
    real_.DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  }
  OwnArrays(const OwnArrays&) = delete;
  OwnArrays& operator=(const OwnArrays&) = delete;

 private:
  void upload(GLenum target, const gl::BufferStorage& contents) {
    GLuint name = 0;
    real_.GenBuffers(1, &name);
    buffers_.push_back(name);
    real_.BindBuffer(target, name);
    real_.BufferData(target, static_cast<GLsizeiptr>(contents.size), contents.data, GL_STREAM_DRAW);
  }
  void add(const ProgramDraw::Array& a) {
    upload(GL_ARRAY_BUFFER, *a.contents);
    real_.EnableVertexAttribArray(a.location);
    const auto* offset = reinterpret_cast<const void*>(a.offset);
    if (a.integer)
      real_.VertexAttribIPointer(a.location, a.size, a.type, a.stride, offset);
    else
      real_.VertexAttribPointer(a.location, a.size, a.type, a.normalized, a.stride, offset);
    if (a.divisor) real_.VertexAttribDivisor(a.location, a.divisor);
  }

  const RealGl& real_;
  GLint savedArray_ = 0, savedBuffer_ = 0;
  GLuint array_ = 0;
  std::vector<GLuint> buffers_;
};

/// State of gl_FrontColor under which draws are traced; the destructor restores the program's.
class BuiltInColors {
 public:
  BuiltInColors(const RealGl& real, const Features& features) : real_(real), exists_(features.compatibility) {
    if (!exists_) return;
    real.GetIntegerv(GL_SHADE_MODEL, &shadeModel_);
    twoSided_ = real.IsEnabled(GL_VERTEX_PROGRAM_TWO_SIDE) == GL_TRUE;
    if (shadeModel_ != GL_SMOOTH) real.ShadeModel(GL_SMOOTH);
    if (twoSided_) real.Disable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  ~BuiltInColors() {
    if (exists_ && shadeModel_ != GL_SMOOTH) real_.ShadeModel(static_cast<GLenum>(shadeModel_));
    if (twoSided_) real_.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  BuiltInColors(const BuiltInColors&) = delete;
  BuiltInColors& operator=(const BuiltInColors&) = delete;

 private:
  const RealGl& real_;
  bool exists_, twoSided_ = false;
  GLint shadeModel_ = GL_SMOOTH;
};

}  // namespace

void drawWithInputs(const RealGl& real, const Features& features, const ProgramDraw& draw,
                    const std::function<void()>& drawIt) {
  StateGuard own(real, features);
  own.program(draw.program);
  own.capability(GL_CULL_FACE, draw.cull);
  if (draw.offset)
    own.polygonOffset(draw.offsetFactor, draw.offsetUnits);
  else
    own.capability(GL_POLYGON_OFFSET_FILL, false);
  real.CullFace(draw.cullFace);
  if (draw.mode == GL_POINTS) real.PointSize(draw.pointSize);
  if (draw.mode != GL_POINTS && draw.mode <= GL_LINE_STRIP) real.LineWidth(draw.lineWidth);
  real.FrontFace(draw.frontFace);
  const KeptUniforms uniforms(real, draw.program, *draw.uniforms);
  for (const UniformValue& value : *draw.uniforms) setUniform(real, value);
  const KeptBlocks blocks(real, draw.blocks);
  const KeptTextures textures(real, draw);
  drawIt();
}

void replayProgramDraws(const RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                        GLenum depthFunc, const std::vector<ProgramDraw>& draws) {
  if (draws.empty()) return;
  StateGuard guard(real, features);
  guard.drawInto(snapshot, depthFunc);
  if (snapshot.layers && snapshot.layers->of == scene::Layers::Of::sums) {
    guard.addUp();
    guard.depthWrites(false);
  } else if (snapshot.layers && snapshot.layers->of == scene::Layers::Of::drawn) {
    guard.blendAs(snapshot.layers->blending);
  }
  replayProgramDraws(real, features, draws);
}

void replayProgramDraws(const RealGl& real, const Features& features, const std::vector<ProgramDraw>& draws) {
  GLint frontFace = GL_CCW, cullFace = GL_BACK;
  real.GetIntegerv(GL_FRONT_FACE, &frontFace);
  real.GetIntegerv(GL_CULL_FACE_MODE, &cullFace);
  GLfloat pointSize = 1;
  real.GetFloatv(GL_POINT_SIZE, &pointSize);
  GLfloat lineWidth = 1;
  real.GetFloatv(GL_LINE_WIDTH, &lineWidth);
  const BuiltInColors colors(real, features);
  for (const ProgramDraw& draw : draws) {
    if (draw.builtIn) continue;
    drawWithInputs(real, features, draw, [&] {
      const OwnArrays arrays(real, draw);
      gl::drawReal(real, draw.mode, draw.elements);
    });
  }
  real.FrontFace(static_cast<GLenum>(frontFace));
  real.PointSize(pointSize);
  real.LineWidth(lineWidth);
  real.CullFace(static_cast<GLenum>(cullFace));
}

}  // namespace gluray::present
