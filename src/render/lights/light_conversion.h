// Converts lights of fixed function and of shader programs to light sources, and back. Called once a frame;
// any thread.
#pragma once
#include "scene/light_source.h"
#include "scene/shading.h"

namespace gluray::render {

/// Converts the light's diffuse part.
scene::LightSource sourceOf(const scene::Light&);
/// A light of a shader program whose lighting space is mapped to eye space by `eyeFromLighting`, which keeps
/// angles. Not for headlights.
scene::LightSource sourceOf(const scene::FragmentLight&, const glm::dmat4& eyeFromLighting);

/// The light at the viewer: in parallel views as far away as the viewer is. `away`: Metric::away.
scene::LightSource headlightOf(float strength, const glm::dvec4& away);

/// Returns an equivalent light of fixed function. An area light becomes a point light at its centre with the
/// falloff of the area along its axis.
scene::Light fixedLight(const scene::LightSource&);
/// Returns an equivalent light for a shader program.
scene::FragmentLight programLight(const scene::LightSource&, const glm::dmat4& lightingFromEye);

}  // namespace gluray::render
