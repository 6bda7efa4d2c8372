// Finds the visible surfaces of an image of light fractions (scene::Snapshot::catches) in the framebuffer.
// Any thread.
#pragma once
#include "base/image.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::present {

/// `seen` becomes the image without pixels whose framebuffer's depth lies behind what they show: there the
/// program drew nothing, as where its shader discards fragments. `depths`: window depths, one for each pixel
/// of the image, bottom row first. The image has one sample a pixel, and its depths lie before the surfaces
/// by the snapshot's polygon offset. Throws std::bad_alloc; reuses the memory of `seen`.
void findSeenCatchers(const Image& image, const scene::Snapshot& snapshot, const std::vector<float>& depths,
                      Image& seen);

}  // namespace gluray::present
