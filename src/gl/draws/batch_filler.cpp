#include "gl/draws/batch_filler.h"

#include "gl/basics/affine.h"
#include "gl/classify/solid_draws.h"
#include "gl/draws/raster_draws.h"
#include "gl/layers/layer_draws.h"
#include "gl/real/state_queries.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace gluray::gl {

void BatchFiller::clampToTarget(scene::Region& region) {
  const auto exceeds = [&](glm::ivec2 size) {
    return region.x + region.width > size.x || region.y + region.height > size.y;
  };
  const TargetState& target = p_.shadow.target();
  const auto& askForSize = p_.shadow.info.drawableSize;
  glm::ivec2 size = target.size;
  if (target.framebuffer == 0) {
    // Queries the size once per batch, since windows may grow, and not once per draw.
    const bool fresh = !p_.pending.batch.empty() && sizeAskedFor_ == region;
    if (!fresh && exceeds(drawableSize_) && askForSize) {
      drawableSize_ = glm::max(drawableSize_, askForSize());
      sizeAskedFor_ = region;
    }
    size = drawableSize_;
  }
  if (size.x <= 0 || size.y <= 0 || !exceeds(size)) return;
  region.width = std::max(0, std::min(region.x + region.width, size.x) - region.x);
  region.height = std::max(0, std::min(region.y + region.height, size.y) - region.y);
}

bool BatchFiller::open(const BatchKey& key, const glm::dmat4& modelview) {
  if (key.region.width <= 0 || key.region.height <= 0) return false;
  Batch& batch = p_.pending.batch;
  if (!batch.empty() && !(batch.key() == key && batch.takes(modelview))) p_.flusher.flush();
  if (!batch.empty()) return true;
  p_.flusher.settleBelow(key.samples);
  batch.start(key, p_.shadow.target(), modelview, p_.shadow.settings, p_.clock.frame, p_.pending.begin());
  if (p_.shadow.settings.changesImage() && !isOn(p_.shadow.real, GL_DITHER)) batch.setUndithered();
  return true;
}

glm::dmat4 BatchFiller::factor(const glm::dmat4& clipFromObject, const glm::dvec3& reach,
                               const BatchKey* there, BatchKey& key, bool flushes) {
  if (there) {
    if (isAffine(glm::inverse(there->projection) * clipFromObject, reach)) key.projection = there->projection;
    if (flushes && !(*there == key)) p_.flusher.flush();
  }
  glm::dmat4 modelview = glm::inverse(key.projection) * clipFromObject;
  modelview /= modelview[3][3];  // homogeneous: maps to the same points
  for (int c = 0; c < 4; ++c) modelview[c][3] = c == 3 ? 1.0 : 0.0;
  return modelview;
}

scene::Instance BatchFiller::instanceOf(const scene::MeshPtr& mesh, SlotMask slots,
                                        const std::vector<MaterialChange>& materials) const {
  ShadowState& shadow = p_.shadow;
  const auto value = [&](Slot slot) { return shadow.current[slot]; };
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = shadow.modelview();
  if (!(slots & bit(kColor))) instance.color = glm::make_vec4(value(kColor));
  if (!(slots & bit(kNormal))) instance.normal = glm::make_vec3(value(kNormal));
  instance.secondaryColor = glm::make_vec3(value(kSecondaryColor));
  instance.fogCoord = *value(kFogCoord);
  if (!(slots & bit(kTexCoord0))) instance.texcoord = glm::make_vec4(value(kTexCoord0));
  for (const scene::Texture& texture : shadow.fixedTextures()) {
    const auto slot = texCoordSlot(texture.unit);
    if (texture.unit == 0 || (slots & bit(slot))) continue;
    instance.texcoordsAbove.resize(texture.unit, glm::vec4(0, 0, 0, 1));
    instance.texcoordsAbove.back() = glm::make_vec4(value(slot));
  }
  instance.materials.reserve(materials.size() + 1);
  const scene::MaterialPair& material = shadow.material();
  instance.materials.push_back(material);
  for (MaterialChange change : materials) {
    if (ignoresColor(slots)) {
      change.front &= static_cast<uint16_t>(~parametersOf(shadow.shading().colorMaterial.front));
      change.back &= static_cast<uint16_t>(~parametersOf(shadow.shading().colorMaterial.back));
    }
    instance.materials.push_back(change.appliedTo(material));
  }
  instance.cull = shadow.raster().cull;
  instance.frontFaceCcw = shadow.raster().frontFaceCcw;
  instance.clipPlanes = shadow.clipPlanes();
  return instance;
}

/// If its vertices have no colours, a surface has the current material, however that was set.
bool BatchFiller::ignoresColor(SlotMask slots) const {
  return p_.shadow.latch.isOn() && !(slots & bit(kColor));
}

scene::Shading BatchFiller::shadingOf(SlotMask slots) const {
  scene::Shading shading = p_.shadow.shading();
  shading.textures = p_.shadow.fixedTextures();
  shading.alphaTest = p_.shadow.raster().alphaTest;
  shading.alphaTest.asBytes =
      shading.alphaTest.function != scene::AlphaTest::always && p_.shadow.target().eightBits;
  if (ignoresColor(slots)) shading.colorMaterial = {};
  return shading;
}

void BatchFiller::add(const scene::MeshPtr& mesh, SlotMask slots,
                      const std::vector<MaterialChange>& materials) {
  BatchKey key = Batch::keyOf(p_.shadow.pixelState(), p_.shadow.projection());
  clampToTarget(key.region);
  if (mesh->triangleCount == 0) return;
  const bool program = p_.shadow.raster().program != 0;
  const bool layer = p_.classifier.isLayer(*mesh, materials);
  if (layer)
    p_.layers.drawn.describe(key, program ? BatchKey::DrawnBy::builtIns : BatchKey::DrawnBy::fixedFunction);
  if (program) return addByProgram(key, mesh, slots);
  if (scene::isSolid(mesh->shape)) return addSolids(key, mesh, slots, materials);
  if (!open(key, p_.shadow.modelview())) return;
  p_.pending.batch.add(instanceOf(mesh, slots, materials), shadingOf(slots));
  reportDrawn(mesh, p_.shadow.modelview(), !layer || key.blending.writesDepth);
  settleFailure();
}

void BatchFiller::addByProgram(const BatchKey& key, const scene::MeshPtr& mesh, SlotMask slots) {
  if (!open(key, p_.shadow.modelview())) return;
  const ProgramState& program = p_.shadow.program();
  scene::Instance instance = instanceOf(mesh, slots, {});
  ProgramDraw kept = captureBuiltInDraw(p_.shadow.real, *program.known, program.uniforms, instance);
  instance.materials = {program.material};
  instance.normalMatrix = program.normalMatrix;
  if (program.eyeFromObject) instance.lightingFromObject = glm::mat4(*program.eyeFromObject);
  p_.pending.batch.add(std::move(instance), program.shading);
  p_.pending.batch.keep(std::move(kept));
  reportDrawn(mesh, p_.shadow.modelview(), key.layers == BatchKey::Layers::none || key.blending.writesDepth);
  settleFailure();
}

void BatchFiller::reportDrawn(const scene::MeshPtr& mesh, const glm::dmat4& modelview, bool leavesDepth) {
  MultipassSurfaces& passes = p_.surfaces.passes;
  const DepthPlace place = depthPlaceOf(p_.shadow);
  if (leavesDepth)
    passes.drawn(mesh, modelview, MultipassSurfaces::How::pending, place, p_.classifier.isPushedBack());
  if (passes.anyTraced() &&
      passes.meetsTraced(mesh, modelview, p_.pending.batch.waiting(), place, leavesDepth))
    p_.raster.rasteriseMet(MultipassSurfaces::Meeting::pending);
}

void BatchFiller::reportDrawnByProgram(const scene::MeshPtr& mesh, const glm::dmat4& modelview,
                                       const glm::dmat4& clipFromObject, bool leavesDepth) {
  MultipassSurfaces& passes = p_.surfaces.passes;
  const DepthPlace place = depthPlaceOf(p_.shadow);
  const Batch& batch = p_.pending.batch;
  if (leavesDepth)
    passes.drawnByProgram(mesh, modelview, clipFromObject, place, batch.key().offset.pushesBack());
  if (passes.anyTraced() &&
      passes.meetsTracedByProgram(mesh, clipFromObject, batch.waiting(), place, leavesDepth))
    p_.raster.rasteriseMet(MultipassSurfaces::Meeting::pending);
}

void BatchFiller::addSolids(BatchKey key, const scene::MeshPtr& mesh, SlotMask slots,
                            const std::vector<MaterialChange>& materials) {
  key.offset = {};  // polygon offset does not apply
  if (!open(key, p_.shadow.modelview())) return;
  scene::Instance instance = instanceOf(mesh, slots, materials);
  scene::Shading shading = shadingOf(slots);
  makeSolid(p_.shadow, instance, shading);
  p_.pending.batch.add(std::move(instance), std::move(shading));
  settleFailure();
}

}  // namespace gluray::gl
