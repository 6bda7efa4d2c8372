// Camera and lights of a view, for files. Any thread.
#pragma once
#include "saved/export/gather/exported_scene.h"
#include "saved/export/gather/scene_views.h"
#include "saved/export/gather/shown_colors.h"
#include "scene/snapshot.h"

namespace gluray::saved {

/// Sets the view's camera from that of its first batch.
void gatherCamera(const scene::Camera&, const glm::dmat4& eyeFromWorld, ExportedView&, Notes&);

/// Sets the view's lights: the program's, of the first surface that is lit.
void gatherLights(const ViewBatches& batches, const glm::dmat4& worldFromEye, ExportedView&, Notes&);

}  // namespace gluray::saved
