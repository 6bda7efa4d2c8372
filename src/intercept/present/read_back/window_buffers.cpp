#include "intercept/present/read_back/window_buffers.h"

#include "gl/real/state_queries.h"
#include "intercept/present/state/state_guard.h"

#include <array>

namespace gluray::present {

bool readWindow(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                frame::WindowContent& out) {
  if (size.x <= 0 || size.y <= 0) return false;
  out.width = size.x, out.height = size.y;
  const auto pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  out.colors.resize(pixels), out.depths.resize(pixels);
  StateGuard guard(real, features);
  guard.plainPack();
  guard.readFrom(0, buffer);
  real.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, out.colors.data());
  real.ReadPixels(0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, out.depths.data());
  return takeErrors(real).empty();
}

namespace {

/// Reads from the framebuffer that choose(guard) binds.
template <class Choose>
GLenum readColorsOf(const gl::RealGl& real, const Features& features, glm::ivec2 size,
                    std::span<uint32_t> out, bool& read, const Choose& choose) {
  const PendingErrors pending = takeErrors(real);
  {
    StateGuard guard(real, features);
    guard.plainPack();
    choose(guard);
    real.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
  }
  read = takeErrors(real).empty();
  return pending.empty() ? GLenum{GL_NO_ERROR} : pending.front();
}

}  // namespace

GLenum readColors(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                  std::span<uint32_t> out, bool& read) {
  return readColorsOf(real, features, size, out, read, [&](StateGuard& guard) { guard.readFrom(0, buffer); });
}

GLenum readBoundColors(const gl::RealGl& real, const Features& features, glm::ivec2 size,
                       std::span<uint32_t> out, bool& read) {
  return readColorsOf(real, features, size, out, read, [](StateGuard&) {});
}

void clearWindow(const gl::RealGl& real, const Features& features, const gl::WindowClear& clear) {
  StateGuard guard(real, features);
  guard.openFragmentPath();
  guard.scissorOff();
  guard.depthWrites(true);
  guard.encoding(false);
  GLbitfield mask = clear.mask;
  // GL_COLOR_CLEAR_VALUE cannot be restored: Mesa clamps what it returns while the window is bound.
  if (mask & GL_COLOR_BUFFER_BIT && features.version >= 30) {
    real.ClearBufferfv(GL_COLOR, 0, clear.color.data());
    mask ^= GL_COLOR_BUFFER_BIT;
  }
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  if (mask & GL_COLOR_BUFFER_BIT) real.GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
  real.GetDoublev(GL_DEPTH_CLEAR_VALUE, &depth);
  const GLint stencil = gl::integer(real, GL_STENCIL_CLEAR_VALUE),
              writes = gl::integer(real, GL_STENCIL_WRITEMASK);
  const bool stencils = mask & GL_STENCIL_BUFFER_BIT;
  if (mask & GL_COLOR_BUFFER_BIT)
    real.ClearColor(clear.color[0], clear.color[1], clear.color[2], clear.color[3]);
  real.ClearDepth(clear.depth);
  if (stencils) real.ClearStencil(clear.stencil), real.StencilMaskSeparate(GL_FRONT, ~0u);
  real.Clear(mask);
  if (stencils) real.ClearStencil(stencil), real.StencilMaskSeparate(GL_FRONT, static_cast<GLuint>(writes));
  real.ClearDepth(depth);
  if (mask & GL_COLOR_BUFFER_BIT) real.ClearColor(color[0], color[1], color[2], color[3]);
}

}  // namespace gluray::present
