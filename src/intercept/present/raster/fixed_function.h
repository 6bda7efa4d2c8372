// Says to the real OpenGL's fixed function what scene::Shading and scene::Instance say. GL thread, used by
// the raster fallback between glPushAttrib and glPopAttrib.
#pragma once
#include "intercept/present/raster/fixed_function_textures.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Everything a snapshot never holds is off: fog, colour sum, programs; texture units too,
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
