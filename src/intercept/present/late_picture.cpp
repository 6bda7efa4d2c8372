#include "intercept/present/late_picture.h"

#include "gl/state_queries.h"

#include <algorithm>

namespace gluray::present {

WindowContent plainWindow(glm::ivec2 size, uint32_t color, float depth) {
  const auto pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  return {size.x, size.y, std::vector<uint32_t>(pixels, color), std::vector<float>(pixels, depth)};
}

bool readWindow(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                WindowContent& out) {
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

/// `over` upon `under`: what is premultiplied by its alpha covers the rest.
uint32_t blended(uint32_t over, uint32_t under) {
  constexpr uint32_t kFull = 255;
  const uint32_t through = kFull - (over >> 24);
  uint32_t result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const uint32_t a = (over >> shift) & kFull, b = (under >> shift) & kFull;
    result |= std::min(kFull, a + (b * through + kFull / 2) / kFull) << shift;
  }
  return result;
}

}  // namespace

bool merge(const Image& image, GLenum depthFunc, WindowContent& content) noexcept {
  if (image.content != Image::Content::color || image.samples != 1) return false;
  const bool averages = !image.center.empty();
  const int left = std::max(0, -image.x), right = std::min(image.width, content.width - image.x);
  for (int y = std::max(0, -image.y); y < std::min(image.height, content.height - image.y); ++y) {
    const size_t from = static_cast<size_t>(y) * static_cast<size_t>(image.width);
    const size_t to = static_cast<size_t>(y + image.y) * static_cast<size_t>(content.width) +
                      static_cast<size_t>(image.x + left);
    for (int x = left; x < right; ++x) {
      const size_t source = from + static_cast<size_t>(x), target = to + static_cast<size_t>(x - left);
      const float depth = image.depth[source], there = content.depths[target];
      if (depth == Image::kMiss || !(depthFunc == GL_LESS ? depth < there : depth <= there)) continue;
      uint32_t& color = content.colors[target];
      color = averages ? blended(image.color[source], color) : image.color[source];
    }
  }
  return true;
}

void clearWindow(const gl::RealGl& real, const Features& features, const gl::WindowClear& clear) {
  StateGuard guard(real, features);
  guard.openFragmentPath();
  guard.scissorOff();
  guard.depthWrites(true);
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
  real.GetDoublev(GL_DEPTH_CLEAR_VALUE, &depth);
  const GLint stencil = gl::integer(real, GL_STENCIL_CLEAR_VALUE),
              mask = gl::integer(real, GL_STENCIL_WRITEMASK);
  const bool stencils = clear.mask & GL_STENCIL_BUFFER_BIT;
  real.ClearColor(clear.color[0], clear.color[1], clear.color[2], clear.color[3]);
  real.ClearDepth(clear.depth);
  if (stencils) real.ClearStencil(clear.stencil), real.StencilMaskSeparate(GL_FRONT, ~0u);
  real.Clear(clear.mask);
  if (stencils) real.ClearStencil(stencil), real.StencilMaskSeparate(GL_FRONT, static_cast<GLuint>(mask));
  real.ClearColor(color[0], color[1], color[2], color[3]);
  real.ClearDepth(depth);
}

}  // namespace gluray::present
