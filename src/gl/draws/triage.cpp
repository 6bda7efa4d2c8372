// Traced or rasterised? Each draw is asked here, and goes into the batch from here.
#include "gl/capture/mesh_builder.h"
#include "gl/context.h"
#include "gl/textures/texture_env.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::gl {

Reason Context::triage(PrimitiveClass kind) {
  if (aside_) return Reason::failure;
  if (passthrough_) return Reason::off;
  if (activeQueries > 0) return Reason::query;
  if (state.target.reason != Reason::traced) return state.target.reason;
  if (state.raster.reason == Reason::renderMode) return Reason::renderMode;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (state.target.wideColors) return Reason::framebuffer;  // fixed function cuts colours off on its way
  if (state.raster.reason != Reason::traced && !layers.mayBeDrawn()) return state.raster.reason;
  if (state.raster.program != 0) return Reason::program;
  if (state.raster.firstVertexProvokes && !state.shading.smooth) return Reason::provokingVertex;
  if (state.textureReason != Reason::traced) return state.textureReason;
  if (!state.modelviewInvertible || !state.projectionInvertible) return Reason::singularMatrix;
  return canTrace() ? Reason::traced : Reason::noGlsl;
}

namespace {

/// Alpha of the primary colour of one face, where it does not come from the vertices; 1 where it does.
float faceAlpha(const scene::Material& material, scene::ColorMaterial::Mode mode) {
  const bool fromVertex =
      mode == scene::ColorMaterial::diffuse || mode == scene::ColorMaterial::ambientAndDiffuse;
  return fromVertex ? 1.0f : material.diffuse.a;
}

bool usesVertexAlpha(const scene::Shading& shading) {
  const auto uses = [](scene::ColorMaterial::Mode m) {
    return m == scene::ColorMaterial::diffuse || m == scene::ColorMaterial::ambientAndDiffuse;
  };
  return !shading.lighting || uses(shading.colorMaterial.front) || uses(shading.colorMaterial.back);
}

bool isOpaque(const scene::Shading& shading, const scene::MaterialPair& material) {
  if (!shading.lighting) return true;
  return faceAlpha(material.front, shading.colorMaterial.front) >= 1.0f &&
         (!shading.twoSided || faceAlpha(material.back, shading.colorMaterial.back) >= 1.0f);
}

/// Whether every point of the mesh has the same window depth: then drawing order, not distance, decides.
bool isFlat(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) {
  double lower = INFINITY, upper = -INFINITY;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 corner(i & 1 ? mesh.upper.x : mesh.lower.x, i & 2 ? mesh.upper.y : mesh.lower.y,
                            i & 4 ? mesh.upper.z : mesh.lower.z, 1);
    const glm::dvec4 clip = clipFromObject * corner;
    const double depth = clip.z / clip.w;
    lower = std::min(lower, depth), upper = std::max(upper, depth);
  }
  constexpr double kDepthStep = 1.0 / (1 << 23);  // of normalised device depth, a 24-bit step and a bit
  return !(upper - lower > kDepthStep);
}

}  // namespace

Reason Context::triage(const KnownMesh& known, const std::vector<MaterialChange>& materials) {
  Reason reason = triageAlways(known, materials);
  const auto place = [&] {
    return sheetPlace(state.projection * state.modelview, Batch::keyOf(state).offset);
  };
  if (reason == Reason::traced && sheets.meets(known.mesh, place())) reason = Reason::coincident;
  if (reason != Reason::traced) return reason;
  if (isLayer(*known.mesh, materials))
    return layers.leavesDrawn(known.mesh->triangleCount) ? Reason::smallScene : Reason::traced;
  const bool leave =
      choice_.way() == EngineChoice::Way::mixed && choice_.takes(known.mesh->triangleCount, viewportPixels());
  return leave ? Reason::smallScene : reason;
}

Reason Context::triageAlways(const KnownMesh& known, const std::vector<MaterialChange>& materials) {
  if (known.homogeneous || !known.mesh) return Reason::homogeneous;
  if (isFarAway(*known.mesh)) return Reason::farAway;
  const glm::dmat4 clipFromObject = state.projection * state.modelview;
  if (precision.isTooLarge(*known.mesh, clipFromObject, {state.viewport.z, state.viewport.w}))
    return Reason::tooLarge;
  if (passes.several(known.mesh->geometryId) ||
      passes.meetsRasterised(*known.mesh, state.modelview, isPushedBack()))
    return Reason::passes;
  if (isFlat(*known.mesh, clipFromObject)) return Reason::flat;
  if (state.raster.unlessOpaque == Reason::traced && state.raster.alphaTest == scene::AlphaTest{})
    return Reason::traced;
  if (isOpaque(*known.mesh, materials)) return Reason::traced;
  if (state.raster.unlessOpaque != Reason::traced && !layers.mayBeDrawn()) return state.raster.unlessOpaque;
  // OpenGL tests once a pixel, at its centre; `--shading sample` does once a sample.
  const bool perSample = state.raster.multisample && state.target.samples > 1;
  return perSample ? Reason::alphaTest : Reason::traced;
}

SheetPlace Context::sheetPlace(const glm::dmat4& clipFromObject, scene::PolygonOffset offset) const {
  offset.resolution = state.target.depthResolution;
  return {state.target.framebuffer, state.viewport, clipFromObject, offset};
}

bool Context::isLayer(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const {
  const RasterState& raster = state.raster;
  return raster.reason != Reason::traced ||
         (raster.unlessOpaque != Reason::traced && !isOpaque(mesh, materials));
}

bool Context::isOpaque(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const {
  const bool vertices =
      !usesVertexAlpha(state.shading) || (mesh.colors ? mesh.opaqueColors : current[kColor][3] >= 1.0f);
  const auto opaque = [&](const scene::MaterialPair& m) { return gl::isOpaque(state.shading, m); };
  return vertices && opaque(state.material) &&
         std::all_of(
             materials.begin(), materials.end(),
             [&](const MaterialChange& change) { return opaque(change.appliedTo(state.material)); }) &&
         keepOpaque(state.textures);
}

void Context::clampToTarget(scene::Region& region) {
  const auto exceeds = [&](glm::ivec2 size) {
    return region.x + region.width > size.x || region.y + region.height > size.y;
  };
  glm::ivec2 size = state.target.size;
  if (state.target.framebuffer == 0) {
    // Asked once a batch, however many draws it takes: windows may grow.
    const bool fresh = !batch_.empty() && sizeAskedFor_ == region;
    if (!fresh && exceeds(drawableSize_) && info_.drawableSize) {
      drawableSize_ = glm::max(drawableSize_, info_.drawableSize());
      sizeAskedFor_ = region;
    }
    size = drawableSize_;
  }
  if (size.x <= 0 || size.y <= 0 || !exceeds(size)) return;
  region.width = std::max(0, std::min(region.x + region.width, size.x) - region.x);
  region.height = std::max(0, std::min(region.y + region.height, size.y) - region.y);
}

void Context::addInstance(const scene::MeshPtr& mesh, SlotMask slots,
                          const std::vector<MaterialChange>& materials) {
  BatchKey key = Batch::keyOf(state);
  clampToTarget(key.region);
  if (key.region.width <= 0 || key.region.height <= 0 || mesh->triangleCount == 0) return;
  const bool layer = isLayer(*mesh, materials);
  if (layer) layers.describe(key);
  if (!batch_.empty() && !(batch_.key() == key)) flush();
  if (batch_.empty()) {
    settleBelow(key.samples);
    batch_.start(key, state, settings_, frame);
  }
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = state.modelview;
  const auto value = [&](Slot slot) { return current[slot]; };
  if (!(slots & bit(kColor)))
    instance.color = {value(kColor)[0], value(kColor)[1], value(kColor)[2], value(kColor)[3]};
  if (!(slots & bit(kNormal))) instance.normal = {value(kNormal)[0], value(kNormal)[1], value(kNormal)[2]};
  instance.secondaryColor = glm::make_vec3(value(kSecondaryColor));
  instance.fogCoord = *value(kFogCoord);
  if (!(slots & bit(kTexCoord0)))
    instance.texcoord = {value(kTexCoord0)[0], value(kTexCoord0)[1], value(kTexCoord0)[2],
                         value(kTexCoord0)[3]};
  for (const scene::Texture& texture : state.textures) {
    const auto slot = texCoordSlot(texture.unit);
    if (texture.unit == 0 || (slots & bit(slot))) continue;
    instance.texcoordsAbove.resize(texture.unit, glm::vec4(0, 0, 0, 1));
    instance.texcoordsAbove.back() = glm::make_vec4(value(slot));
  }
  instance.materials.reserve(materials.size() + 1);
  instance.materials.push_back(state.material);
  for (const MaterialChange& change : materials)
    instance.materials.push_back(change.appliedTo(state.material));
  instance.cull = state.raster.cull;
  instance.frontFaceCcw = state.raster.frontFaceCcw;
  instance.clipPlanes = state.clipPlanes;
  scene::Shading shading = state.shading;
  shading.textures = state.textures;
  shading.alphaTest = state.raster.alphaTest;
  shading.alphaTest.asBytes =
      shading.alphaTest.function != scene::AlphaTest::always && state.target.eightBits;
  // Without colours or materials at its vertices the surface has the current material, however it came about.
  if (latch.isOn() && !(slots & bit(kColor)) && materials.empty()) shading.colorMaterial = {};
  batch_.add(std::move(instance), std::move(shading));
  if (!layer || key.blending.writesDepth)
    passes.drawn(mesh, state.modelview, Passes::How::pending, isPushedBack());
  if (aside_) flush();  // the flush above failed: later draws are rasterised and must find this one drawn
}

bool Context::mayMeetPasses(PrimitiveClass kind) const {
  return meetsDepth(kind) && passes.anyUnder(state.modelview);
}

bool Context::meetsDepth(PrimitiveClass kind) const {
  const RasterState& raster = state.raster;
  const bool tested = raster.reason != Reason::renderMode && raster.reason != Reason::noDepthTest &&
                      raster.depthFunc != GL_ALWAYS && raster.depthFunc != GL_NEVER;
  return kind == PrimitiveClass::surfaces && tested && !aside_;
}

bool Context::isPass(PrimitiveClass kind, Reason reason) const {
  return kind == PrimitiveClass::surfaces && state.raster.writesDepth &&
         (reason == Reason::colorMask || reason == Reason::passes || reason == Reason::smallScene);
}

void Context::rememberPass(const KnownMesh& known) {
  if (known.mesh) passes.drawn(known.mesh, state.modelview, Passes::How::rasterised, isPushedBack());
}

void Context::meetPasses(std::span<const Triangle> triangles) {
  protect([&] {
    settleBelow(state.target.samples);
    rasteriseMet(passes.meets(state.modelview, triangles, isPushedBack()));
  });
}

void Context::rasteriseMet(Passes::Meeting meeting) {
  if (meeting == Passes::Meeting::pending) present(Reason::passes);
  for (const DepthAgain& again : passes.takeTraced()) {
    syncCurrent();
    PresentTarget target{.core = info_.core, .rasterise = true, .depthAgain = true};
    if (again.clipFromObject) target.byMatrix = {again.mesh, *again.clipFromObject};
    const PresentResult result = presenter_.present(real, again.snapshot, target);
    latch.restore(real);
    if (result.pendingError != GL_NO_ERROR) setError(result.pendingError);
  }
}

bool Context::isPushedBack() const {
  const RasterState& raster = state.raster;
  const scene::PolygonOffset offset{.factor = raster.offsetFactor, .units = raster.offsetUnits};
  return raster.offsetFill && raster.reason != Reason::polygonMode && offset.pushesBack();
}

void Context::countAsRasterised(const scene::Snapshot& snapshot, Reason reason) {
  uint64_t triangles = 0;
  for (const scene::Instance& instance : snapshot.instances) triangles += instance.mesh->triangleCount;
  const uint64_t draws = std::min<uint64_t>(snapshot.instances.size(), statistics.drawsTraced);
  triangles = std::min<uint64_t>(triangles, statistics.trianglesTraced);
  statistics.drawsTraced -= draws;
  statistics.trianglesTraced -= triangles;
  statistics.drawsRasterised += draws;
  statistics.rasterisedBecause[static_cast<size_t>(reason)] += draws;
  statistics.trianglesRasterised += triangles;
}

void Context::beforeRasterDraw(PrimitiveClass kind) {
  if (window.lags()) protect([&] { window.showLagged(); });
  if (window.shows()) protect([&] { window.settleBelow(); });
  // What was to be traced before it was known to lie in one plane with this draw is rasterised with it.
  if (sheets.takeFound() && !batch_.empty() &&
      (batch_.key().layers == BatchKey::Layers::none || batch_.key().layers == BatchKey::Layers::drawn) &&
      batch_.key().framebuffer == state.target.framebuffer)
    protect([&] { present(Reason::coincident); });
  if (resolves.any()) protect([&] { resolves.meetRasterDraw(); });
  if (layers.pending()) protect([&] { layers.meetRasterDraw(); });
  if (!batch_.empty()) {
    refresh(kRaster);
    // Lines and points on a surface have its depth: who comes later matters unless the surface was pushed
    // back.
    const bool coplanar = kind != PrimitiveClass::surfaces && batch_.key().offset == scene::PolygonOffset{};
    // Colours of sums meet in floats; those of drawn layers, in their order.
    const bool seenThrough =
        batch_.key().layers == BatchKey::Layers::summed || batch_.key().layers == BatchKey::Layers::drawn;
    // What the program counts or stores depends on the depth that it meets.
    const bool writes = state.raster.program != 0 && programs.known(state.raster.program)->program.writes;
    // A channel that one of the two leaves alone has what the other one, or an earlier one, left there.
    const bool channels = !(state.raster.colorWrites == batch_.key().colorWrites);
    if (!state.raster.orderFree || coplanar || seenThrough || writes || channels) flush();
  }
  forgetClear();
  syncCurrent();
}

void Context::countRaster(Reason reason, DrawPath path, PrimitiveClass kind, uint64_t triangles) {
  if (kinds()) [[unlikely]] {
    const auto& program = programs.inUse();
    kinds()->record(real, state.target, reason, path, kind, triangles, program, state.program.why);
  }
  ++statistics.drawsRasterised;
  ++statistics.rasterisedBecause[static_cast<size_t>(reason)];
  statistics.trianglesRasterised += triangles;
  noteLoad(triangles);
}

void Context::countTraced(DrawPath path, uint64_t triangles) {
  if (kinds()) [[unlikely]]
    kinds()->record(real, state.target, Reason::traced, path, PrimitiveClass::surfaces, triangles,
                    programs.inUse());
  ++statistics.drawsTraced;
  statistics.trianglesTraced += triangles;
  noteLoad(triangles);
  current.drawn();
}

}  // namespace gluray::gl
