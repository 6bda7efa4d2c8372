// Whether triangles of a frame lie exactly upon each other, so that the order of drawing decides which is
// seen. Owned by World; one thread at a time.
#pragma once
#include "base/background_job.h"
#include "base/hash.h"
#include "scene/snapshot.h"

#include <atomic>
#include <memory>
#include <unordered_map>
#include <vector>

namespace gluray::accel {

/// Whether two triangles of `meshes`, all in one space, have the same three corners, in whatever order.
/// Triangles without area do not count. May say yes where two hashes of 64 bits are equal by chance. Ends
/// early, with any answer, once `cancelled` is set. Takes some 30 ns and 4 bytes a triangle.
bool anyCoincide(const std::vector<const scene::Mesh*>& meshes, const std::atomic<bool>& cancelled);

/// Remembers the answers: geometry that stays is looked at once, where it is large behind the frames.
class Coincidence {
 public:
  /// Whether triangles of these instances may coincide: true as long as it is not known.
  bool possible(const std::vector<scene::Instance>& instances);

 private:
  /// Instances with one transform: only their triangles can have the same corners.
  struct Group {
    std::vector<const scene::Mesh*> meshes;
    bool repeated = false;  // the same geometry twice
    Hash128 id;             // of what is in it, whatever the order
    uint64_t triangles = 0;
  };
  static std::vector<Group> groupsOf(const std::vector<scene::Instance>& instances);
  bool known(const Group& group);
  void lookBehind(const Group& group);
  void collect();

  enum class Answer : uint8_t { asked, no, yes };  // asked: in an earlier frame, and not answered
  std::unordered_map<Hash128, Answer> answers_;
  Hash128 looking_;                           // the group that the job looks at
  std::shared_ptr<std::atomic<bool>> found_;  // what it found
  BackgroundJob job_;
};

}  // namespace gluray::accel
