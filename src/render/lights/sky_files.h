// Reads images of skies. Any thread.
#pragma once
#include "render/lights/sky_image.h"

#include <string>

namespace gluray::render {

/// Reads Radiance .hdr (also .pic) or OpenEXR, by the file's first bytes. Throws std::runtime_error without
/// the path if the file cannot be read, has more than 2^25 pixels, or has another format.
SkyPixels readSkyPixels(const std::string& path);

/// From files' contents: Radiance's RGBE, with or without run lengths (G. Ward, "Real Pixels",
/// 1991).
SkyPixels readRadiance(const std::string& bytes);

/// OpenEXR, single images of scan lines or tiles; throws if GLuRay was built without OpenEXR.
SkyPixels readOpenExr(const std::string& bytes);

}  // namespace gluray::render
