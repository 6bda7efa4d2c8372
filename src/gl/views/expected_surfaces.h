// The surfaces that a view is expected to draw later in its frame, because it did so in the last one. Used by
// ViewScenes, GL thread.
#pragma once
#include "gl/views/secondary_scene_builder.h"
#include "gl/views/view_epoch.h"

#include <glm/glm.hpp>

namespace gluray::gl {

/// Adds what `last` drew after the batches that are drawn again by now, as it has `moved`. `first`: the first
/// snapshot of the view in this frame; `s`: the one whose secondary scene `maker` makes.
void addLater(const ViewEpoch& last, const Repetition& now, const glm::dmat4& moved,
              const scene::Snapshot& first, const scene::Snapshot& s, SecondarySceneBuilder& maker);

/// How the view has moved since the epoch that it repeats, by what was drawn again up to the batch `s`.
/// `epoch`: what the view has drawn in this frame; null: nothing.
glm::dmat4 movementOf(const ViewEpoch& last, const ViewEpoch* epoch, const Repetition& now,
                      const scene::Snapshot& s);

}  // namespace gluray::gl
