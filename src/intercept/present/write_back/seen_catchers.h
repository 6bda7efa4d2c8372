// Finds the visible surfaces of an image of light fractions (scene::Snapshot::catches) in the framebuffer.
// Any thread.
#pragma once
#include "base/image.h"
#include "intercept/present/write_back/taken_light.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::present {

/// `seen` becomes the image without pixels whose framebuffer's depth lies behind what they show: there the
/// program drew nothing, as where its shader discards fragments. `depths`: window depths, one for each pixel
/// of the image, bottom row first. The image has one sample a pixel, and its depths lie before the surfaces
/// by the snapshot's polygon offset. Throws std::bad_alloc; reuses the memory of `seen`.
void findSeenCatchers(const Image& image, const scene::Snapshot& snapshot, const std::vector<float>& depths,
                      Image& seen);

/// The same for images whose colours are bytes: the opacities of the seen pixels that also pass the depth
/// test GL_LEQUAL against `depths`. Throws std::bad_alloc; reuses the memory of `taken`.
void findTakenLight(const Image& image, const scene::Snapshot& snapshot, const std::vector<float>& depths,
                    TakenLight& taken);

}  // namespace gluray::present
