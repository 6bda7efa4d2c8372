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

/// Denoises the colours of `out`, the mean of the passes. Returns false on failure; some pixels may then be
/// denoised, others not.
bool denoise(const Refinement&, const Settings&, Image& out) noexcept;

/// Logs once that images are not denoised.
void logNoFilter(const std::string& why) noexcept;

}  // namespace gluray::frame
