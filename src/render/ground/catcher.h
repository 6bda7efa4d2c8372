// The look of a catcher: nothing but the light that surfaces take from it. Tracing threads.
#pragma once
#include "render/integrators/integrator.h"

namespace gluray::render {

/// Replaces the colours of hits on the catcher by black whose opacity is the share of light that does not
/// arrive, 1 - L / L0: L with and L0 without all other surfaces, both as luminance. Nothing falls on what
/// no light reaches anyway.
void catchLight(const Integrator&, const ColoredHits&, ColorRows&) noexcept;

}  // namespace gluray::render
