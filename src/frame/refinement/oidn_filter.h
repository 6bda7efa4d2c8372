// Denoises images by Intel Open Image Denoise (setting denoise). Any thread.
#pragma once
#include "base/image.h"
#include "frame/refinement/oidn_library.h"
#include "frame/refinement/refinement.h"

#include <string>
#include <vector>

namespace gluray::frame {

/// Denoises the plane of `image` that begins at pixel `first`: writes its RGB, row by row, to `out`, in the
/// space of the mean; values may exceed 1. The library gets light, that is the mean divided by reflectance,
/// as linear HDR values: means of samples are linear in the samples, whatever the framebuffer's encoding.
/// Pixels that show no surface get light 1. `threads`: 0: one for each core. Returns false with a reason on
/// failure. Throws std::bad_alloc.
bool smoothByOidn(const OidnLibrary&, const Refinement&, int threads, const Image& image, size_t first,
                  std::vector<float>& out, std::string& why);

}  // namespace gluray::frame
