// Texture images as PNG files. Any thread.
#pragma once
#include "saved/export/gather/exported_scene.h"

#include <string>

namespace gluray::saved {

/// The base level, eight bits a channel, with alpha unless all of it is 1. `upright`: its last row first, so
/// that it shows as OpenGL has it; otherwise the rows in their order. Throws std::runtime_error.
std::string pngOf(const scene::TextureImage&, ExportedTexture::Texels, bool upright, const PngEncoder&);

}  // namespace gluray::saved
