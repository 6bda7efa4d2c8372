#include "gl/flush/relighting.h"

#include "base/timeline.h"
#include "gl/real/draw_binding.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"
#include "scene/replaced_pixels.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {

void Relighting::update(GLuint framebuffer) {
  if (p_.surfaces.views.empty() || p_.failsafe.aside() || p_.clock.measured()) return;
  std::vector<Replaced> replaced;
  for (const ViewScenes::Outdated& one : p_.surfaces.views.outdated(framebuffer)) {
    const DrawBinding binding(p_.shadow.real, framebuffer);
    const auto buffer = static_cast<GLenum>(integer(p_.shadow.real, GL_DRAW_BUFFER));
    if (buffer != one.drawBuffer) continue;
    if (auto made = relight(one, replaced)) replaced.push_back(std::move(*made));
  }
}

namespace {

/// The texture that holds what `framebuffer` shows in its draw buffer; 0: none does.
GLuint colorTexture(const RealGl& real, GLuint framebuffer) {
  const DrawBinding binding(real, framebuffer);
  const auto buffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER));
  if (buffer == GL_NONE) return 0;
  const auto value = [&](GLenum name) { return attachmentValue(real, GL_DRAW_FRAMEBUFFER, buffer, name); };
  if (value(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return 0;
  return static_cast<GLuint>(value(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
}

/// Whether a texture is bound to one of the first units.
bool isBound(const RealGl& real, GLuint texture) {
  constexpr GLint kUnits = 16;
  const GLint active = integer(real, GL_ACTIVE_TEXTURE);
  const GLint units = std::min(kUnits, integer(real, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS));
  bool bound = false;
  for (GLint unit = 0; unit < units && !bound; ++unit) {
    real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    for (const GLenum binding : {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_MULTISAMPLE})
      bound = bound || static_cast<GLuint>(integer(real, binding)) == texture;
  }
  real.ActiveTexture(static_cast<GLenum>(active));
  return bound;
}

}  // namespace

void Relighting::finishSampled() {
  for (const GLuint framebuffer : p_.surfaces.views.unchecked()) {
    if (framebuffer == 0 || framebuffer == p_.shadow.target().framebuffer) continue;
    p_.shadow.errors.keepPending();
    const GLuint texture = colorTexture(p_.shadow.real, framebuffer);
    if (texture != 0 && isBound(p_.shadow.real, texture)) finish(framebuffer);
    p_.shadow.errors.takeReal();  // of a context without multisampled textures
  }
}

void Relighting::finishAt(Place place) {
  if (place == Place::sampling) return finishSampled();
  if (place == Place::read) {
    const bool objects = p_.shadow.rare().framebufferObjects;
    return finish(objects ? static_cast<GLuint>(integer(p_.shadow.real, GL_READ_FRAMEBUFFER_BINDING)) : 0);
  }
  for (const GLuint framebuffer : p_.surfaces.views.unchecked())
    if (framebuffer != 0 || place == Place::leaving) finish(framebuffer);
}

namespace {

/// Layers that were drawn over images which have changed since, over the changed ones.
template <class Replacements>
scene::SnapshotPtr drawnOver(const scene::SnapshotPtr& snapshot, const Replacements& below) {
  const bool isOver = snapshot->layers && snapshot->layers->of == scene::Layers::Of::drawn;
  if (!isOver || below.empty()) return snapshot;
  auto layers = std::make_shared<scene::Layers>(*snapshot->layers);
  for (const auto& one : below) replaceUnder(*layers, snapshot->region, *one.before, *one.now);
  if (layers->colors == snapshot->layers->colors) return snapshot;
  auto over = std::make_shared<scene::Snapshot>(*snapshot);
  over->layers = std::move(layers);
  return over;
}

}  // namespace

std::optional<Relighting::Replaced> Relighting::relight(ViewScenes::Outdated one,
                                                        const std::vector<Replaced>& below) {
  const timeline::Span span("relight", one.now->instances.size());
  one.now = drawnOver(one.now, below);
  if (one.now == one.before) return std::nullopt;
  if (p_.counts.decisions()) [[unlikely]]
    p_.counts.decisions()->relit(one.now->instances.size());
  ++p_.counts.statistics.imagesRelit;
  ImageWish wish = p_.clock.wish();
  wish.anew = true, wish.averages = one.written->isAverages();
  p_.shadow.current.shelve(p_.shadow.real);
  const PresentResult result = p_.pending.presenter.relight(
      p_.shadow.real, one.before, one.now, {*one.written, one.later, p_.shadow.info.core, wish});
  p_.pending.takeResult(result);
  // Where it failed, the picture keeps the light that it has.
  if (result.outcome != PresentResult::traced) return std::nullopt;
  p_.surfaces.views.relit(one, result.written);
  return Replaced{one.written, result.written};
}

}  // namespace gluray::gl
