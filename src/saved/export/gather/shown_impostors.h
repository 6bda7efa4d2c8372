// The impostors of an instance as round shapes. Any thread.
#pragma once
#include "saved/export/arrays/round_shapes.h"
#include "saved/export/gather/shown_colors.h"
#include "scene/snapshot.h"

namespace gluray::saved {

/// The shapes in the space of Instance::lightingFromObject. Of impostors that have a volume or are discs: not
/// of beads, tubes and splats. `colors`: of the mesh's vertices.
std::vector<RoundShape> shapesOf(const scene::Instance&, const scene::Camera&, const ShownColors& colors,
                                 bool flat, Notes&);

}  // namespace gluray::saved
