#include "gl/share_group.h"

#include "gl/buffers/buffer.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {

bool ShareGroup::anyBuffersHeldBack() const {
  if (!Buffer::anyHeldBack()) return false;
  const auto all = buffers.all();
  return std::any_of(all.begin(), all.end(), [](const auto& b) { return b->heldBack(); });
}

void ShareGroup::discardRealList(GLuint id) {
  const std::lock_guard lock(mutex_);
  discarded_.lists.push_back(id);
}

void ShareGroup::discard(const SharedNames& names) {
  const auto add = [](std::vector<GLuint>& to, const std::vector<GLuint>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  const std::lock_guard lock(mutex_);
  add(discarded_.lists, names.lists), add(discarded_.textures, names.textures);
  add(discarded_.programs, names.programs);
}

SharedNames ShareGroup::takeDiscarded() {
  const std::lock_guard lock(mutex_);
  return std::exchange(discarded_, {});
}

std::shared_ptr<const KnownProgram> ShareGroup::program(const RealGl& real, GLuint name,
                                                        const FamilyList& families) {
  const std::lock_guard lock(programsMutex_);
  std::shared_ptr<const KnownProgram>& known = programs_[name];
  if (known) return known;
  const auto texts = texts_.find(name);
  known = recognise(real, name, families, texts == texts_.end() ? nullptr : texts->second);
  return known;
}

void ShareGroup::programChanged(GLuint name) {
  const std::lock_guard lock(programsMutex_);
  programs_.erase(name), texts_.erase(name);
}

void ShareGroup::programLinked(const RealGl& real, GLuint name) {
  std::shared_ptr<const ShaderTexts> texts = readShaderTexts(real, name);
  const std::lock_guard lock(programsMutex_);
  programs_.erase(name);
  texts_[name] = std::move(texts);
}

}  // namespace gluray::gl
