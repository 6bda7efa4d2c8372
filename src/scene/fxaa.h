// Settings of fast approximate anti-aliasing (FXAA) as VTK's full-screen pass has it.
#pragma once

namespace gluray::scene {

/// Contrasts are of luminosity, 0 .. 1.
struct Fxaa {
  float relativeContrast = 0.125f;    // of the brightest neighbour, below which a pixel stays
  float hardContrast = 0.045f;        // below which it stays whatever its neighbours
  float subpixelBlendLimit = 0.75f;   // most that single bright or dark pixels are blended
  float subpixelContrast = 0.25f;     // from which they are
  int endpointSearchIterations = 12;  // pixels that an edge is followed
};

}  // namespace gluray::scene
