#include "gl/views/expected_surfaces.h"

#include "scene/same_camera.h"

namespace gluray::gl {

void addLater(const ViewEpoch& last, const Repetition& now, const glm::dmat4& moved,
              const scene::Snapshot& first, const scene::Snapshot& s, SecondarySceneBuilder& maker) {
  maker.nextFrame();
  for (size_t i = 0; i < now.repeated; ++i) maker.skip(*last.batches[i].snapshot);
  for (size_t i = now.repeated; i < last.batches.size(); ++i) {
    const ViewEpoch::Drawn& later = last.batches[i];
    const auto viewFromPart = eyeFromEye(last.first(), *later.snapshot), eyeFromView = eyeFromEye(s, first);
    if (!viewFromPart || !eyeFromView) continue;
    // What stood still while the first surfaces moved does so again.
    const glm::dmat4 inView = later.still && last.moves ? glm::dmat4(1) : moved;
    const glm::dmat4 inPart = inView == glm::dmat4(1) || *viewFromPart == glm::dmat4(1)
                                  ? inView
                                  : glm::inverse(*viewFromPart) * inView * *viewFromPart;
    maker.add(*later.snapshot, *eyeFromView * *viewFromPart, later.capture, later.erased, inPart);
  }
}

glm::dmat4 movementOf(const ViewEpoch& last, const ViewEpoch* epoch, const Repetition& now,
                      const scene::Snapshot& s) {
  Movement movement;
  size_t repeated = 0;
  if (epoch)
    for (const ViewEpoch::Drawn& drawn : epoch->batches) {
      const Repetition earlier = repetitionOf(last, repeated, *drawn.snapshot);
      if (earlier.of) movement.compare(*earlier.of->snapshot, *drawn.snapshot);
      repeated = earlier.repeated;
    }
  if (now.of) movement.compare(*now.of->snapshot, s);
  return movement.shared().value_or(glm::dmat4(1));
}

}  // namespace gluray::gl
