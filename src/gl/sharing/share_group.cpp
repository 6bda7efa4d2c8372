#include "gl/sharing/share_group.h"

#include "gl/buffers/buffer.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {

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
  unrecognised_.erase(name);
  ++programChanges_;
  return known;
}

std::shared_ptr<const KnownProgram> ShareGroup::recognised(GLuint name) {
  const std::lock_guard lock(programsMutex_);
  const auto it = programs_.find(name);
  return it == programs_.end() ? nullptr : it->second;
}

GLuint ShareGroup::unrecognised() {
  const std::lock_guard lock(programsMutex_);
  return unrecognised_.empty() ? 0 : *unrecognised_.begin();
}

bool ShareGroup::tracesPrograms() {
  const std::lock_guard lock(programsMutex_);
  return std::ranges::any_of(programs_, [](const auto& p) { return p.second && p.second->family; });
}

void ShareGroup::programDeleted(GLuint name) {
  const std::lock_guard lock(programsMutex_);
  programs_.erase(name), texts_.erase(name), unrecognised_.erase(name);
  ++programChanges_;
}

void ShareGroup::programChanged(GLuint name) {
  const std::lock_guard lock(programsMutex_);
  programs_.erase(name), texts_.erase(name);
  unrecognised_.insert(name);
  ++programChanges_;
}

void ShareGroup::programLinked(const RealGl& real, GLuint name) {
  std::shared_ptr<const ShaderTexts> texts = readShaderTexts(real, name);
  const std::lock_guard lock(programsMutex_);
  programs_.erase(name);
  unrecognised_.insert(name);
  ++programChanges_;
  texts_[name] = std::move(texts);
}

}  // namespace gluray::gl
