// Sets the real OpenGL's fixed-function state from scene::Shading and scene::Instance. GL thread, used by the
// raster fallback between glPushAttrib and glPopAttrib.
#pragma once
#include "intercept/present/raster/fixed_function_textures.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Disables all state that the other functions do not set: fog, colour sum, programs; also texture units,
/// which setShading() sets.
void neutralFixedFunction(const gl::RealGl& real, const Features& features);
/// Lighting, lights, normalisation, shade model, textures.
void setShading(const gl::RealGl& real, const Features& features, const scene::Shading& shading,
                ShadingTextures& textures);
/// Modelview matrix, clip planes, culling, first material.
void setInstanceState(const gl::RealGl& real, const scene::Instance& instance);
/// May be called between glBegin and glEnd.
void setMaterials(const gl::RealGl& real, const scene::MaterialPair& materials);

}  // namespace gluray::present
