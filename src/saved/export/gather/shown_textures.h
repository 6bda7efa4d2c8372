// The textures of draws as textures of exported materials, as far as those can express them. Any thread.
#pragma once
#include "render/local/surface.h"
#include "saved/export/arrays/mesh_arrays.h"
#include "saved/export/gather/exported_scene.h"
#include "saved/export/gather/shown_colors.h"

#include <optional>

namespace gluray::saved {

/// The image with its sampler; none if the format has no such textures. Notes what is approximated.
std::optional<ExportedTexture> exportedTexture(const scene::Texture&, Notes&);

/// The texture coordinates of the vertices; none if they cannot be coordinates of a plain texture.
std::optional<SourcePtr> exportedCoordinates(const render::Surface&, const scene::Texture&,
                                             const CornersPtr& corners);

/// How a single texture changes colours: the product of both, or the texture's colour alone.
struct TextureEffect {
  bool keepsColor = true, keepsAlpha = true;  // of the colour before
  ExportedTexture::Texels texels = ExportedTexture::Texels::all;
};
/// None: another function of both. `opaque`: the colours before have alpha 1.
std::optional<TextureEffect> effectOf(const scene::Shading&, const scene::Texture&, bool opaque);

/// A program's colour map with the sampling that programs use: clamped to the edge, one level.
scene::Texture asMap(scene::Texture map);

}  // namespace gluray::saved
