// Exposure and tone mapping of hits' colours (settings exposure, tone). Made once a frame, called on tracing
// threads.
#pragma once
#include "render/local/group.h"
#include "scene/snapshot.h"

#include <optional>

namespace gluray::render {

/// Decodes colours to linear light, applies exposure and a curve, and encodes them again. Framebuffers hold
/// sRGB values, unless OpenGL itself encodes colours on writing.
///   reinhard  L / (1 + L), L being the luminance; hue stays (E. Reinhard and others, "Photographic Tone
///             Reproduction for Digital Images", 2002, equation 3)
///   aces      K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2015, with that page's exposure factor of 0.6
///   filmic    J. Hable, "Filmic Tonemapping Operators", 2010, with that page's exposure bias of 2 and white
///             at 11.2
///   shoulder  the largest channel x becomes x up to a = 0.6 and a + (1 - a) (1 - exp((a - x) / (1 - a)))
///             beyond; the others shrink with it
struct ToneMap {
  float exposure = 1;  // factor of linear light
  Tone curve = Tone::none;
  bool encoded = true;  // colours are sRGB values

  /// Changes red, green and blue; alpha stays.
  void apply(ColorRows&) const;
};

/// None if neither the settings nor `factor`, of linear light, change colours.
std::optional<ToneMap> makeToneMap(const scene::Snapshot&, float factor = 1);

}  // namespace gluray::render
