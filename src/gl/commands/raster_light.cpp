#include "gl/commands/raster_light.h"

#include "gl/arrays/assembly.h"
#include "gl/basics/affine.h"
#include "gl/capture/mesh_builder.h"
#include "gl/commands/array_draws.h"
#include "gl/context/context.h"
#include "gl/real/state_queries.h"
#include "scene/effects.h"

#include <GL/glext.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace gluray::gl {
namespace {

constexpr GLenum kClipDistances = 8;  // OpenGL's minimum; llvmpipe has no more

bool isWanted(const Settings& settings) {
  return settings.light.rasterised && settings.look == Look::program && scene::wantsLight(settings);
}

bool isClipped(ShadowState& shadow) {
  if (!shadow.clipPlanes().empty()) return true;
  for (GLenum i = 0; i < kClipDistances; ++i)
    if (isOn(shadow.real, GL_CLIP_DISTANCE0 + i)) return true;
  return false;
}

/// LightReason::lit, or the reason why the draw may have written less than colours and depth. The depths show
/// which fragments it did not write, unless the framebuffer is multisampled.
LightReason litState(Context& c, GLenum mode, const Elements& e) {
  ShadowState& shadow = c.shadow;
  if (e.instances >= 0 && (e.instances != 1 || e.baseInstance != 0)) return LightReason::instanced;
  if (const CullReason reason = c.culled.reasonOfState(mode); reason != CullReason::culled)
    return lightReason(reason);
  const RasterState& raster = shadow.raster();
  if (raster.isReversed()) return LightReason::reversedDepth;
  if (!raster.colorWrites.all()) return LightReason::colorMask;
  const bool stippled = raster.butDepthFunc == Reason::polygonStipple;
  if (shadow.target().samples > 1 && (stippled || raster.alphaTest != scene::AlphaTest{}))
    return stippled ? LightReason::polygonStipple : LightReason::alphaTest;
  if (shadow.target().encodes) return LightReason::framebuffer;
  return isClipped(shadow) ? LightReason::clipDistances : LightReason::lit;
}

/// Makes the surface matte, and dark, so that the sum of lights stays below 1. It has no lights of its own:
/// the setting `lights` adds them.
void makeMatte(scene::Instance& instance, scene::Shading& shading) {
  constexpr float kDark = 1.0f / 16;
  shading.fragment.model = scene::FragmentShading::Model::phong;
  shading.fragment.normals = scene::FragmentShading::Normals::triangles;
  scene::Material material;
  material.ambient = material.diffuse = glm::vec4(glm::vec3(kDark), 1);
  material.specular = glm::vec4(0, 0, 0, 1);
  instance.materials = {{material, material}};
}

/// Makes the surface unlit. Mirrors and paths then show the colours that were drawn, regardless of the light
/// that reaches the surface.
void makeUnlit(scene::Instance& instance, scene::Shading& shading) {
  makeMatte(instance, shading);
  shading.fragment.model = scene::FragmentShading::Model::unlit;
}

/// A key with the camera of surfaces that are already waiting, so that the new ones can wait with them.
std::optional<BatchKey> likelyKey(const PendingBatch& pending, bool paths) {
  if (const BatchKey* key = paths ? pending.capturedSurfaces.likely(pending.batch) : nullptr) return *key;
  return paths || pending.batch.empty() ? std::nullopt : std::optional(pending.batch.key());
}

void addSurface(Context& c, const scene::MeshPtr& mesh, const glm::dmat4& clipFromObject) {
  const bool paths = scene::wantsPaths(c.shadow.settings);
  BatchKey key = Batch::keyOf(c.shadow.pixelState(), clipFromObject);
  key.layers = BatchKey::Layers::visibility;
  key.depthFunc = GL_LEQUAL;
  c.filler.clampToTarget(key.region);
  if (key.region.width <= 0 || key.region.height <= 0) return;
  const std::optional<BatchKey> there = likelyKey(c.pending, paths);
  const glm::dmat4 modelview =
      c.filler.factor(clipFromObject, reachOf(*mesh), there ? &*there : nullptr, key, !paths);
  if (!paths && !c.filler.open(key, modelview)) return;
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = modelview;
  instance.cull = c.shadow.raster().cull;
  instance.frontFaceCcw = c.shadow.raster().frontFaceCcw;
  scene::Shading shading;
  if (paths) {
    makeUnlit(instance, shading);
    return c.pending.capturedSurfaces.add(key, std::move(instance), std::move(shading), c.pending.batch);
  }
  makeMatte(instance, shading);
  c.pending.batch.add(std::move(instance), std::move(shading));
  c.filler.settleFailure();
}

LightReason light(Context& c, GLenum mode, const Elements& e) {
  ShadowState& shadow = c.shadow;
  if (const LightReason reason = litState(c, mode, e); reason != LightReason::lit) return reason;
  if (!c.pending.canTrace()) return LightReason::noGlsl;
  CulledDraws::Surface from;
  if (const CullReason reason = c.culled.findSurface(mode, e, from); reason != CullReason::culled)
    return lightReason(reason);
  if (from.instanced) return LightReason::instanced;
  if (from.discards && shadow.target().samples > 1) return LightReason::leavesOut;
  const bool restarts = assemblyOf(shadow.real, false, mode, e).restart.has_value();
  if (!from.positions->enabled || restarts) return LightReason::arrayState;
  ArrayState positions;
  positions.vertex = *from.positions;
  positions.vertex.size = std::min(from.positions->size, from.components);
  positions.elements = from.arrays->elements;
  if (foreignReason(positions) != Reason::traced) return LightReason::foreignBuffer;
  const KnownMesh known = meshOf(c, positions, mode, e);
  if (known.homogeneous || !known.mesh) return LightReason::homogeneous;
  if (known.mesh->triangleCount == 0) return LightReason::lit;
  if (isFarAway(*known.mesh)) return LightReason::farAway;
  const glm::dmat4& matrix = from.clipFromObject;
  if (!isInvertible(matrix)) return LightReason::singularMatrix;
  const glm::ivec4& viewport = shadow.viewport().box;
  const glm::ivec2 size(viewport.z, viewport.w);
  if (RayPrecision::isFarFromOrigin(*known.mesh, matrix, size)) return LightReason::farFromOrigin;
  if (c.surfaces.precision.isTooLarge(*known.mesh, matrix, size)) return LightReason::tooLarge;
  addSurface(c, known.mesh, matrix);
  return LightReason::lit;
}

}  // namespace

void lightRasterised(Context& c, GLenum mode, const Elements& e) noexcept {
  if (!isWanted(c.shadow.settings) || c.failsafe.aside() || c.shadow.info.off) return;
  c.protect([&] { c.counts.lit(light(c, mode, e)); });
}

}  // namespace gluray::gl
