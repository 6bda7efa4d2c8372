#include "intercept/present/read_back/finished_framebuffer.h"

#include "gl/state/state_queries.h"
#include "intercept/present/write_back/state_guard.h"

#include <GL/glext.h>

#include <memory>
#include <utility>

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

/// Whether pixels of the bound read framebuffer are bytes.
bool holdsBytes(const gl::RealGl& real, bool window) {
  auto buffer = static_cast<GLenum>(gl::integer(real, GL_READ_BUFFER));
  if (window && buffer == GL_FRONT) buffer = GL_FRONT_LEFT;
  if (window && buffer == GL_BACK) buffer = GL_BACK_LEFT;
  const auto value = [&](GLenum name) {
    return gl::attachmentValue(real, GL_READ_FRAMEBUFFER, buffer, name);
  };
  return buffer != GL_NONE && value(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED &&
         value(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 8 && value(GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE) == 8 &&
         value(GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE) == 8;
}

/// Whether the program reads much of a framebuffer of this size, as for a screenshot, not a few picked
/// pixels.
bool isMuch(const scene::Region& read, glm::ivec2 size) {
  constexpr int64_t kShare = 4;
  return read.x >= 0 && read.y >= 0 && read.width > 0 && read.height > 0 &&
         kShare * read.width * read.height >= int64_t{size.x} * size.y;
}

}  // namespace

PresentResult FinishedFramebuffer::bind(const gl::RealGl& real, PresentedPictures& shared,
                                        const scene::Region& read) {
  PresentResult result;
  frame::FramePictures& frame = shared.pictures.frame();
  const glm::ivec2 pictures = frame.size();
  if (pictures.x <= 0 || pictures.y <= 0 || !isMuch(read, pictures)) return result;
  const Features& has = shared.features(real);
  const glm::ivec2 size = glm::max(pictures, glm::ivec2(read.x + read.width, read.y + read.height));
  if (!has.readFramebuffers || size.x > has.maxTextureSize || size.y > has.maxTextureSize) return result;
  const PendingErrors pending = takeErrors(real);
  if (!pending.empty()) result.pendingError = pending.front();
  program_ = static_cast<GLuint>(gl::integer(real, GL_READ_FRAMEBUFFER_BINDING));
  WindowPixels pixels{size.x, size.y, {}};
  pixels.colors.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  bool usable = holdsBytes(real, program_ == 0);
  if (usable) {
    StateGuard guard(real, has);
    guard.plainPack();
    real.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.colors.data());
  }
  usable = takeErrors(real).empty() && usable;  // of framebuffers with samples, or that are incomplete
  if (!usable) return result;
  const auto window = std::make_shared<ReadPixels>(std::move(pixels));
  const frame::FramePictures::Finished finished = frame.finishIn(window);
  result.passes = finished.passes;
  if (finished.noise > 0) result.noise = finished.noise;
  if (!finished.any) return result;
  make(real, has, window->pixels());
  if (takeErrors(real).empty() && copy_ != 0)
    result.outcome = PresentResult::traced;
  else
    unbind(real);
  return result;
}

void FinishedFramebuffer::make(const gl::RealGl& real, const Features& has, const WindowPixels& pixels) {
  real.GenTextures(1, &texture_);
  {
    StateGuard guard(real, has);
    guard.plainUnpack();
    guard.texture2D(has.textureUnit, texture_);
    real.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    real.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    pixels.colors.data());
  }
  real.GenFramebuffers(1, &copy_);
  real.BindFramebuffer(GL_READ_FRAMEBUFFER, copy_);
  real.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  if (real.CheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) unbind(real);
}

void FinishedFramebuffer::unbind(const gl::RealGl& real) noexcept {
  real.BindFramebuffer(GL_READ_FRAMEBUFFER, program_);
  if (copy_ != 0) real.DeleteFramebuffers(1, &copy_);
  if (texture_ != 0) real.DeleteTextures(1, &texture_);
  copy_ = texture_ = 0;
}

}  // namespace gluray::present
