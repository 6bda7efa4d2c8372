// Parameters of fast approximate anti-aliasing (FXAA), as in VTK's full-screen pass.
#pragma once

namespace gluray::scene {

/// Contrasts are differences of luminosity, 0 .. 1.
struct Fxaa {
  float relativeContrast = 0.125f;    // threshold relative to the brightest neighbour: below, a pixel stays
  float hardContrast = 0.045f;        // absolute threshold: below, a pixel stays
  float subpixelBlendLimit = 0.75f;   // largest blend weight of isolated bright or dark pixels
  float subpixelContrast = 0.25f;     // contrast from which isolated pixels are blended
  int endpointSearchIterations = 12;  // how far an edge is followed, pixels
};

}  // namespace gluray::scene
