// Assigns object numbers to the surfaces of a context, which stay constant across frames. A part of
// DrawnObjects, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/objects/object_matching.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

/// A surface gets its earlier number by the first of these rules that applies. 1. Another pass draws it again
/// in the same frame. 2. Its geometry was in the last frame; surfaces of equal geometry are matched by
/// position, in eye space or in world space, whichever matches more of them, then by drawing order. 3. Its
/// geometry was drawn in an earlier frame, but not in the last one. 4. It lies between matched surfaces in
/// the drawing order. All other surfaces are new objects.
class ObjectNumbers {
 public:
  /// Begins a frame, whose surfaces are matched with those of the last one.
  void beginFrame();
  /// Numbers the surfaces of a batch. Throws std::bad_alloc; some surfaces then have no number.
  void number(const BatchKey& key, scene::Snapshot& batch);
  /// Whether the frame has drawn nothing yet.
  bool fresh() const { return now_.empty(); }

 private:
  struct Known {
    ObjectTraits traits;
    uint32_t number = 0;
    size_t view = 0;     // index in the frame
    uint32_t batch = 0;  // index in the view
    glm::mat4 place{1};  // worldFromObject: the world is that of the batch's first surface
    glm::mat4 inEye{1};  // eyeFromObject
    bool taken = false;  // matched in this frame
  };
  struct View {
    GLuint framebuffer = 0;
    glm::ivec4 viewport{0};
    scene::Camera camera;
    double distance = 0;      // distance of the world origin from the eye
    size_t last = kNoObject;  // index of the same view in the last frame
    uint32_t batches = 0;
    size_t next = 0;                                      // index in last_ after the surfaces matched so far
    std::unordered_multimap<Hash128, uint32_t> numbered;  // by geometry and place in eye space
  };
  struct Batch;
  size_t viewOf(const BatchKey& key, const scene::Snapshot& batch);
  size_t lastViewOf(const View& view) const;
  void takeDrawnBefore(Batch& batch);
  void takeByGeometry(Batch& batch);
  struct Pair {
    size_t instance, known;  // index in the batch, and in last_
  };
  std::vector<Pair> atOnePlace(Batch& batch, const std::vector<size_t>& instances,
                               std::vector<size_t> candidates, glm::mat4 Known::*space) const;
  void takeByPlace(Batch& batch, std::vector<size_t>& instances, std::vector<size_t>& candidates);
  void takeGone(Batch& batch);
  void takeByOrder(Batch& batch);
  void alignGap(Batch& batch, size_t begin, size_t end, size_t first, size_t last);
  void takeNumber(Batch& batch, size_t instance, size_t known);
  void finish(Batch& batch);

  std::vector<Known> last_, now_;  // in drawing order
  std::vector<View> lastViews_, views_;
  std::unordered_multimap<Hash128, size_t> lastAt_;  // by geometry: indices of last_
  // Geometry drawn before, but not in the last frame, and its numbers.
  std::unordered_multimap<Hash128, uint32_t> gone_;
  std::deque<Hash128> goneSince_;  // oldest first; may include geometry that was drawn again
};

}  // namespace gluray::gl
