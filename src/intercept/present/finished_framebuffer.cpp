#include "intercept/present/finished_framebuffer.h"

#include "gl/real/state_queries.h"
#include "intercept/present/state/state_guard.h"

#include <GL/glext.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace gluray::present {

using gl::PresentResult;

namespace {

/// Pixels that were read. Refined colours keep their alpha.
class ReadPixels final : public IdleWindow {
 public:
  explicit ReadPixels(WindowPixels pixels) : pixels_(std::move(pixels)) {}
  const WindowPixels& pixels() const { return pixels_; }
  bool read(WindowPixels& out) noexcept override {
    try {
      out = pixels_;
      return true;
    } catch (const std::exception&) { return false; }
  }
  bool replace(const WindowPixels&, const WindowPixels& next) noexcept override {
    constexpr uint32_t kAlpha = 0xff000000u;
    for (size_t i = 0; i < pixels_.colors.size(); ++i)
      pixels_.colors[i] = (pixels_.colors[i] & kAlpha) | (next.colors[i] & ~kAlpha);
    return true;
  }

 private:
  WindowPixels pixels_;
};

/// The attachment that GL_READ_BUFFER names.
GLenum readAttachment(const gl::RealGl& real, bool window) {
  const auto buffer = static_cast<GLenum>(gl::integer(real, GL_READ_BUFFER));
  if (!window) return buffer;
  switch (buffer) {
    case GL_FRONT:
    case GL_LEFT: return GL_FRONT_LEFT;
    case GL_RIGHT: return GL_FRONT_RIGHT;
    case GL_BACK: return GL_BACK_LEFT;
    default: return buffer;
  }
}

/// Whether pixels of the bound read framebuffer are bytes.
bool holdsBytes(const gl::RealGl& real, bool window) {
  const GLenum buffer = readAttachment(real, window);
  const auto value = [&](GLenum name) {
    return gl::attachmentValue(real, GL_READ_FRAMEBUFFER, buffer, name);
  };
  return buffer != GL_NONE && value(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED &&
         value(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 8 && value(GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE) == 8 &&
         value(GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE) == 8;
}

int64_t overlap(int a, int aSize, int b, int bSize) {
  return std::min(int64_t{a} + aSize, int64_t{b} + bSize) - std::max(a, b);
}

/// Whether the program reads so much of the images as for a screenshot, not a few picked pixels.
bool coversMuch(const scene::Region& read, const std::vector<scene::Region>& images) {
  constexpr int64_t kShare = 4;
  int64_t covered = 0, all = 0;
  for (const scene::Region& r : images) {
    const int64_t x = overlap(read.x, read.width, r.x, r.width),
                  y = overlap(read.y, read.height, r.y, r.height);
    if (x > 0 && y > 0) covered += x * y;
    all += int64_t{r.width} * r.height;
  }
  return covered > 0 && kShare * covered >= all;
}

/// The size of a framebuffer that has room for what is read and for the images; 0: it is larger than
/// `most`.
glm::ivec2 sizeFor(const scene::Region& read, const std::vector<scene::Region>& images, int64_t most) {
  int64_t x = int64_t{read.x} + read.width, y = int64_t{read.y} + read.height;
  for (const scene::Region& r : images)
    x = std::max(x, int64_t{r.x} + r.width), y = std::max(y, int64_t{r.y} + r.height);
  return x <= most && y <= most ? glm::ivec2(x, y) : glm::ivec2(0);
}

}  // namespace

/// The bound read framebuffer's pixels; none: it does not hold bytes of one sample. No error may be pending.
WindowPixels FinishedFramebuffer::read(const gl::RealGl& real, StateGuard& guard, glm::ivec2 size) const {
  WindowPixels pixels{size.x, size.y, {}};
  pixels.colors.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  const bool usable = holdsBytes(real, program_ == 0);
  if (usable) {
    guard.plainPack();
    real.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.colors.data());
  }
  // Errors of framebuffers with samples, or that are incomplete.
  if (!takeErrors(real).empty() || !usable) pixels.colors.clear();
  return pixels;
}

PresentResult FinishedFramebuffer::bind(const gl::RealGl& real, PresentedImages& shared,
                                        const scene::Region& region) {
  PresentResult result;
  result.repeated = true;  // until something is traced
  frame::FrameImages& frame = shared.images.frame();
  const std::vector<scene::Region> images = frame.regions();
  if (!coversMuch(region, images)) return result;
  const Features& has = shared.features(real);
  const glm::ivec2 size = sizeFor(region, images, has.maxTextureSize);
  if (!has.readFramebuffers || size.x == 0) return result;
  const PendingErrors pending = takeErrors(real);
  if (!pending.empty()) result.pendingError = pending.front();
  try {
    StateGuard guard(real, has);
    program_ = static_cast<GLuint>(gl::integer(real, GL_READ_FRAMEBUFFER_BINDING));
    WindowPixels pixels = read(real, guard, size);
    if (pixels.colors.empty()) return result;
    const auto window = std::make_shared<ReadPixels>(std::move(pixels));
    const frame::FrameImages::Finished finished = frame.finishIn(window);
    result.passes = finished.passes, result.cost = finished.cost, result.repeated = finished.passes == 0;
    if (finished.noise > 0) result.noise = finished.noise;
    if (!finished.any) return result;
    make(real, guard, has, window->pixels());
    if (takeErrors(real).empty()) return result.outcome = PresentResult::traced, result;
  } catch (const std::exception&) {}  // out of memory: the program reads what is there
  unbind(real, has);
  takeErrors(real);
  return result;
}

void FinishedFramebuffer::make(const gl::RealGl& real, StateGuard& guard, const Features& has,
                               const WindowPixels& pixels) {
  real.GenTextures(1, &texture_);
  guard.plainUnpack();
  guard.texture2D(has.textureUnit, texture_);
  real.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  real.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  pixels.colors.data());
  real.GenFramebuffers(1, &copy_);
  real.BindFramebuffer(GL_READ_FRAMEBUFFER, copy_);
  real.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  if (real.CheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("a framebuffer of RGBA8 is incomplete");
}

void FinishedFramebuffer::unbind(const gl::RealGl& real, const Features& has) noexcept {
  const auto release = [&] {
    if (copy_ != 0) real.BindFramebuffer(GL_READ_FRAMEBUFFER, program_), real.DeleteFramebuffers(1, &copy_);
    if (texture_ != 0) real.DeleteTextures(1, &texture_);
    copy_ = texture_ = 0;
  };
  try {
    const StateGuard guard(real, has);
    release();
  } catch (const std::exception&) { release(); }  // out of memory for the guard
}

}  // namespace gluray::present
