// Denoises refined images (setting denoise). Any thread.
#pragma once
#include "base/image.h"
#include "frame/refinement/refinement.h"
#include "scene/light_sampling.h"
#include "settings/settings.h"

#include <string>

namespace gluray::frame {

/// Stores the auxiliary features of a pass of the mode reflectance or geometry. Throws std::bad_alloc.
void keepFeatures(scene::LightSampling::Mode mode, const Image& pass, AuxiliaryFeatures& features);

/// Paths and rays a pixel up to which Open Image Denoise is better than the filter (docs/adr/0099).
constexpr uint32_t kFewPaths = 4, kFewRays = 16;

/// Whether Open Image Denoise is to denoise the image if it is found. `auto`: finished images of few samples.
bool wantsOidn(const Refinement&, const Settings&);

/// Denoises the colours of `out`, the mean of the passes. Returns false on failure; some pixels may then be
/// denoised, others not.
bool denoise(const Refinement&, const Settings&, Image& out) noexcept;

/// Logs once that images are not denoised.
void logNoFilter(const std::string& why) noexcept;

}  // namespace gluray::frame
