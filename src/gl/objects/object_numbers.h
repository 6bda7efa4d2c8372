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

/// Surfaces are known again, in this order: drawn again in the same frame by another pass; by their geometry,
/// those that have equal geometry by their places, in eye space or in the world, whichever fits more of them,
/// then in the order of drawing; by geometry that was drawn in an earlier frame and left out since; by their
/// place in the order of drawing, between surfaces that are known. All others are new objects.
class ObjectNumbers {
 public:
  /// A frame begins: what it draws is compared with what the last one drew.
  void beginFrame();
  /// Numbers the surfaces of a batch. Throws std::bad_alloc; some then have no number.
  void number(const BatchKey& key, scene::Snapshot& batch);
  /// Whether the frame has drawn nothing yet.
  bool fresh() const { return now_.empty(); }

 private:
  struct Known {
    ObjectTraits traits;
    uint32_t number = 0;
    size_t view = 0;     // of the frame
    uint32_t batch = 0;  // of the view
    glm::mat4 place{1};  // worldFromObject: the world is that of the batch's first surface
    glm::mat4 inEye{1};  // eyeFromObject
    bool taken = false;  // drawn again in this frame
  };
  struct View {
    GLuint framebuffer = 0;
    glm::ivec4 viewport{0};
    scene::Camera camera;
    double distance = 0;      // of what it shows, from the origin of eye space
    size_t last = kNoObject;  // index of the same view in the last frame
    uint32_t batches = 0;
    size_t next = 0;                                      // in last_: after what was drawn again so far
    std::unordered_multimap<Hash128, uint32_t> numbered;  // by geometry and place in eye space
  };
  struct Batch;
  size_t viewOf(const BatchKey& key, const scene::Snapshot& batch);
  size_t lastViewOf(const View& view) const;
  void takeDrawnBefore(Batch& batch);
  void takeByGeometry(Batch& batch);
  struct Pair {
    size_t instance, known;  // indices of the batch, and of last_
  };
  std::vector<Pair> atOnePlace(Batch& batch, const std::vector<size_t>& instances,
                               std::vector<size_t> candidates, glm::mat4 Known::*space) const;
  void takeByPlace(Batch& batch, std::vector<size_t>& instances, std::vector<size_t>& candidates);
  void takeGone(Batch& batch);
  void takeByOrder(Batch& batch);
  void alignGap(Batch& batch, size_t begin, size_t end, size_t first, size_t last);
  void takeNumber(Batch& batch, size_t instance, size_t known);
  void finish(Batch& batch);

  std::vector<Known> last_, now_;  // in the order of drawing
  std::vector<View> lastViews_, views_;
  std::unordered_multimap<Hash128, size_t> lastAt_;  // by geometry: indices of last_
  // Drawn before, but not in the last frame: numbers by geometry.
  std::unordered_multimap<Hash128, uint32_t> gone_;
  std::deque<Hash128> goneSince_;  // the oldest first; may name some that were drawn again
};

}  // namespace gluray::gl
