// Surfaces that the real OpenGL has drawn from fixed function's vertices in this depth epoch, by modelview
// matrix, as samples of their triangles. Traced depth differs from their depth in the last bits. A part of
// MultipassSurfaces, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/capture/triangle_samples.h"
#include "gl/history/depth_history.h"
#include "scene/mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::gl {

/// Hash of a matrix; equal matrices have equal hashes.
Hash128 hashOf(const glm::dmat4& matrix);

class SampledSurfaces {
 public:
  void add(const glm::dmat4& eyeFromObject, std::vector<Triangle> triangles, const DepthStamp& at,
           bool pushedBack);
  /// Whether `holds(stamp, triangles)` is true for a sample that has this matrix and this value of
  /// `pushedBack`, and whose bounding box overlaps that of the mesh.
  template <class Holds>
  bool any(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject, bool pushedBack,
           const Holds& holds) const {
    const auto found = size_ > 0 ? groups_.find(hashOf(eyeFromObject)) : groups_.end();
    if (found == groups_.end()) return false;
    const Group& group = found->second;
    for (size_t i = 0; i < group.boxes.size(); ++i)
      if (group.boxes[i].pushedBack == pushedBack && group.boxes[i].meetsBoxOf(mesh) &&
          holds(group.boxes[i].at, group.triangles[i]))
        return true;
    return false;
  }
  size_t size() const { return size_; }
  void clear() { groups_.clear(), size_ = 0; }
  /// Forgets the samples for which `gone(stamp)` is true.
  template <class Gone>
  void eraseIf(const Gone& gone) {
    size_ = 0;
    for (auto it = groups_.begin(); it != groups_.end();) {
      it->second.eraseIf(gone);
      size_ += it->second.boxes.size();
      it = it->second.boxes.empty() ? groups_.erase(it) : std::next(it);
    }
  }

 private:
  struct Box {
    glm::vec3 lower{0}, upper{0};
    bool pushedBack = false;
    DepthStamp at;
    bool meetsBoxOf(const scene::Mesh& mesh) const;
  };
  /// The samples of one matrix, with one box each.
  struct Group {
    std::vector<Box> boxes;
    std::vector<std::vector<Triangle>> triangles;
    template <class Gone>
    void eraseIf(const Gone& gone) {
      size_t kept = 0;
      for (size_t i = 0; i < boxes.size(); ++i) {
        if (gone(boxes[i].at)) continue;
        if (kept != i) boxes[kept] = boxes[i], triangles[kept] = std::move(triangles[i]);
        ++kept;
      }
      boxes.resize(kept), triangles.resize(kept);
    }
  };
  std::unordered_map<Hash128, Group> groups_;
  size_t size_ = 0;  // samples in all groups
};

}  // namespace gluray::gl
