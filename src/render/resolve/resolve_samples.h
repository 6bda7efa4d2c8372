// Resolves the samples of a multisampled image into pixels, on the CPU. Called by frame::Renderer.
#pragma once
#include "base/image.h"
#include "scene/resolve.h"

namespace gluray::render {

/// Sets `out` to `how.size` pixels from (0, 0), with one sample each and no misses. Colours average all
/// samples; depths are those of the first sample (OpenGL 4.6, 18.3.1: any one sample), or of the pixel
/// centres if pixels average several rays. Clips `samples`, whose colour plane is `color`. Runs on the
/// threads of the calling arena.
void resolve(const scene::Resolve& how, const Image& samples, Image& out);

}  // namespace gluray::render
