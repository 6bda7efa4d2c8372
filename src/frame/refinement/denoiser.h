// Smooths the noise of refined pictures (setting denoise). Any thread.
#pragma once
#include "base/image.h"
#include "frame/refinement/refinement.h"
#include "scene/light_sampling.h"
#include "settings/settings.h"

#include <string>

namespace gluray::frame {

/// Keeps what a pass of the mode reflectance or geometry found. Throws std::bad_alloc.
void keepGuides(scene::LightSampling::Mode mode, const Image& pass, LightGuides& guides);

/// Smooths the colours of `out`, which shows the mean of the passes. False: it failed, and some pixels may be
/// smoothed, others not.
bool denoise(const Refinement&, const Settings&, Image& out) noexcept;

/// Says once that pictures are not smoothed.
void logNoFilter(const std::string& why) noexcept;

}  // namespace gluray::frame
