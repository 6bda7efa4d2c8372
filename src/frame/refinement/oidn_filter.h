// Intel Open Image Denoise, where GLuRay is built with it (setting denoise = oidn). Any thread.
#pragma once
#include "base/image.h"
#include "frame/refinement/refinement.h"
#include "settings/settings.h"

#include <string>
#include <vector>

namespace gluray::frame {

/// Denoises the plane of `image` that begins at pixel `first`: writes its RGB, row by row, to `out`. Colours
/// are display values, 0 .. 1. Returns false with a reason on failure, also if GLuRay was built without the
/// library. Throws std::bad_alloc.
bool smoothByOidn(const Refinement&, const Settings&, const Image& image, size_t first,
                  std::vector<float>& out, std::string& why);

}  // namespace gluray::frame
