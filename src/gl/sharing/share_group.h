// Objects that several contexts share: display lists, buffers, known meshes. The tables are locked inside,
// because contexts may be current on several threads. The objects are not locked: host programs must
// synchronise their use, as OpenGL requires.
#pragma once
#include "gl/capture/mesh_cache.h"
#include "gl/programs/match.h"
#include "gl/sharing/deleted_buffers.h"
#include "gl/sharing/deleted_images.h"
#include "gl/sharing/shared_names.h"

#include <GL/gl.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace gluray::gl {

class DisplayList;
class Buffer;

/// Thread-safe map from OpenGL names to objects.
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
  /// Erases `count` names from `first`, in time O(min(count, objects)).
  void eraseRange(GLuint first, GLuint count) {
    const std::lock_guard lock(mutex_);
    if (count < objects_.size()) {
      for (GLuint i = 0; i < count; ++i) objects_.erase(first + i);
    } else {
      std::erase_if(objects_, [&](const auto& entry) { return entry.first - first < count; });
    }
  }
  /// Reserves `count` consecutive unused names, with null objects, and returns the first; 0 if there is no
  /// such range. Like Mesa, prefers names above all ever used, which needs no search.
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
  GLuint highest_ = 0;  // highest name ever used
  std::unordered_map<GLuint, std::shared_ptr<Object>> objects_;
};

class ShareGroup {
 public:
  NameTable<DisplayList> lists;
  NameTable<const std::string> listLabels;  // of those lists that the program labelled
  NameTable<Buffer> buffers;
  DeletedBuffers deletedBuffers;
  DeletedImages deletedImages;
  MeshCache meshes;
  std::atomic<int> contexts = 0;             // number of existing contexts
  std::atomic<uint64_t> textureChanges = 0;  // count of changes to texture images by any context
  std::atomic<bool> stencilsSet =
      false;  // some image may hold stencil values; until then OpenGL leaves them undefined

  const std::shared_ptr<std::atomic<int>> heldBackBuffers = std::make_shared<std::atomic<int>>(0);
  bool anyBuffersHeldBack() const { return *heldBackBuffers > 0; }

  /// The shader program and its family, which is determined once per link. A context of the group must be
  /// current.
  std::shared_ptr<const KnownProgram> program(const RealGl& real, GLuint name, const FamilyList& families);
  /// The shader program got a new binary: its family is determined anew if it is still used.
  void programChanged(GLuint name);
  /// The shader program was deleted: its family is determined anew if it is still used.
  void programDeleted(GLuint name);
  /// The shader program was linked: keeps the texts of its shaders, which the host program may detach. A
  /// context of the group must be current.
  void programLinked(const RealGl& real, GLuint name);
  /// Counts shader programs that were linked, deleted or recognised.
  uint64_t programChanges() const { return programChanges_; }
  /// The last result of program() for this shader program; null if there is none.
  std::shared_ptr<const KnownProgram> recognised(GLuint name);
  /// A shader program that was linked or got a binary, and for which program() was not called since; 0: none.
  GLuint unrecognised();
  /// Whether a family describes one of the recognised shader programs.
  bool tracesPrograms();

  /// Schedules a real list without owner for deletion by the next current context of the group.
  void discardRealList(GLuint id);
  /// Schedules all names that a context leaves behind for deletion.
  void discard(const SharedNames& names);
  /// Returns the names to delete and forgets them.
  SharedNames takeDiscarded();

 private:
  std::mutex mutex_;
  SharedNames discarded_;
  std::mutex programsMutex_;
  std::unordered_map<GLuint, std::shared_ptr<const KnownProgram>> programs_;
  std::unordered_map<GLuint, std::shared_ptr<const ShaderTexts>> texts_;
  std::unordered_set<GLuint> unrecognised_;
  std::atomic<uint64_t> programChanges_ = 0;
};

}  // namespace gluray::gl
