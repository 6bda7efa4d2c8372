// Lights of fixed function and of shader programs as light sources, and light sources as theirs. Made once a
// frame; any thread.
#pragma once
#include "scene/light_source.h"
#include "scene/shading.h"

namespace gluray::render {

/// The light's diffuse part.
scene::LightSource sourceOf(const scene::Light&);
/// A light of a shader program whose lighting space is mapped to eye space by `eyeFromLighting`, which keeps
/// angles. Not for headlights.
scene::LightSource sourceOf(const scene::FragmentLight&, const glm::dmat4& eyeFromLighting);

/// The light of fixed function that shines like the source; areas shine like a point in their middle whose
/// strength falls with the distance as theirs does along their axis.
scene::Light fixedLight(const scene::LightSource&);
/// The same for a shader program.
scene::FragmentLight programLight(const scene::LightSource&, const glm::dmat4& lightingFromEye);

}  // namespace gluray::render
