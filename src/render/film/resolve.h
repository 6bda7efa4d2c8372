// Pixels out of the samples of a multisampled picture, on the CPU. Runs on the threads of the calling arena.
#pragma once
#include "base/image.h"
#include "scene/resolve.h"

namespace gluray::render {

/// `out` has one sample a pixel, `how.size` of them from (0, 0) on, and no misses: colours are the averages
/// over all samples, depths those of the first sample, as OpenGL has it (4.6, 18.3.1: any one sample). What
/// of `samples`, whose content is `color`, lies outside is left out.
void resolve(const scene::Resolve& how, const Image& samples, Image& out);

}  // namespace gluray::render
