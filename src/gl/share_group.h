// Objects that several contexts share: display lists, buffers, known meshes. Locked inside, so that contexts
// may be current in several threads; the objects themselves follow OpenGL's rule that programs synchronise
// their use.
#pragma once
#include "gl/batch/presenter.h"
#include "gl/buffers/attachments.h"
#include "gl/capture/mesh_cache.h"
#include "gl/families/match.h"

#include <GL/gl.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

class DisplayList;
class Buffer;

/// Names and what they stand for.
template <class Object>
class NameTable {
 public:
  std::shared_ptr<Object> find(GLuint name) const {
    const std::lock_guard lock(mutex_);
    const auto it = objects_.find(name);
    return it == objects_.end() ? nullptr : it->second;
  }
  bool contains(GLuint name) const {
    const std::lock_guard lock(mutex_);
    return objects_.contains(name);
  }
  void put(GLuint name, std::shared_ptr<Object> object) {
    const std::lock_guard lock(mutex_);
    highest_ = std::max(highest_, name);
    objects_[name] = std::move(object);
  }
  void erase(GLuint name) {
    const std::lock_guard lock(mutex_);
    objects_.erase(name);
  }
  /// Erases `count` names from `first`; as quick for absurd counts as for few objects.
  void eraseRange(GLuint first, GLuint count) {
    const std::lock_guard lock(mutex_);
    if (count < objects_.size()) {
      for (GLuint i = 0; i < count; ++i) objects_.erase(first + i);
    } else {
      std::erase_if(objects_, [&](const auto& entry) { return entry.first - first < count; });
    }
  }
  /// First of `count` consecutive unused names, which are taken with null objects; 0 where there are none.
  /// Above all that were ever used where there is room, as Mesa does: no search among many.
  GLuint reserve(GLuint count) {
    const std::lock_guard lock(mutex_);
    GLuint first = highest_ < 0xFFFFFFFFu - count ? highest_ + 1 : 1;
    for (GLuint i = 0; i < count;) {
      if (first > 0xFFFFFFFFu - count) return 0;
      if (objects_.contains(first + i))
        first += i + 1, i = 0;
      else
        ++i;
    }
    for (GLuint i = 0; i < count; ++i) objects_.emplace(first + i, nullptr);
    highest_ = std::max(highest_, first + count - 1);
    return first;
  }
  std::vector<std::shared_ptr<Object>> all() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<Object>> result;
    for (const auto& [name, object] : objects_)
      if (object) result.push_back(object);
    return result;
  }

 private:
  mutable std::mutex mutex_;
  GLuint highest_ = 0;  // name ever used
  std::unordered_map<GLuint, std::shared_ptr<Object>> objects_;
};

class ShareGroup {
 public:
  NameTable<DisplayList> lists;
  NameTable<Buffer> buffers;
  DeletedBuffers deletedBuffers, deletedRenderbuffers;
  MeshCache meshes;
  std::atomic<int> contexts = 0;             // alive
  std::atomic<uint64_t> textureChanges = 0;  // of texture images, by calls of any context
  std::atomic<bool> stencilsSet =
      false;  // possibly, in any image; until then OpenGL leaves open what is there

  bool anyBuffersHeldBack() const;

  /// The program with its family; recognised once a link. Context of the group current.
  std::shared_ptr<const KnownProgram> program(const RealGl& real, GLuint name, const FamilyList& families);
  /// It is linked anew, or gone: to be recognised again.
  void programChanged(GLuint name);

  /// Real lists whose owner is gone; deleted by the next context of the group that is current.
  void discardRealList(GLuint id);
  /// The same for whatever a context leaves behind.
  void discard(const SharedNames& names);
  SharedNames takeDiscarded();

 private:
  std::mutex mutex_;
  SharedNames discarded_;
  std::mutex programsMutex_;
  std::unordered_map<GLuint, std::shared_ptr<const KnownProgram>> programs_;
};

}  // namespace gluray::gl
