// Denoises refined images (setting denoise). Any thread.
#pragma once
#include "base/image.h"
#include "frame/refinement/refinement.h"
#include "scene/snapshot.h"
#include "settings/settings.h"

#include <string>

namespace gluray::frame {

/// Whether the snapshot's images are denoised: `denoise` is on, and nothing below stands against it.
bool isDenoised(const scene::Snapshot&);
/// Logs once why `denoise` has no effect on the snapshot's images, if it is on and has none.
void logUndenoised(const scene::Snapshot&) noexcept;

/// Paths and rays a pixel up to which Open Image Denoise is better than the filter (docs/adr/0101).
constexpr uint32_t kFewPaths = 4, kFewRays = 16;

/// Whether Open Image Denoise is to denoise the image if it is found. `auto`: finished images of few rays
/// whose pixels each show one surface.
bool wantsOidn(const Refinement&, const Settings&);

/// Denoises the colours of `out`, the mean of the passes, and the alpha of shadow catchers. Returns false on
/// failure; some pixels may then be denoised, others not.
bool denoise(const Refinement&, const Settings&, Image& out) noexcept;

/// Logs once that images are not denoised.
void logNoFilter(const std::string& why) noexcept;

}  // namespace gluray::frame
