// Plans of culled draws: everything that is determined before anything is drawn.
#include "gl/culled/cullable_state.h"
#include "gl/culled/culled_draws.h"
#include "gl/culled/instances/instance_arrays.h"
#include "gl/real/state_queries.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

constexpr uint64_t kUnusedFrames = 8;  // a mesh that is unused for this long is forgotten
constexpr int kSteadyFrames = 3;       // frames with the same data before clusters are built

}  // namespace

CullReason CulledDraws::plan(GLenum mode, const Elements& e, Plan& found) {
  ShadowState& shadow = p_.shadow;
  found.mode = mode, found.elements = e;
  if (const CullReason reason = cullableState(shadow, mode); reason != CullReason::culled) return reason;
  mapWindow(found);
  if (found.region.width <= 0 || found.region.height <= 0) return CullReason::smallDraw;
  if (!choosePlace(found)) return CullReason::samplesInUse;
  Source from;
  const CullReason reason = source(mode, e, from);
  if (reason == CullReason::positions && shadow.raster().program != 0) return planFeedback(found);
  if (reason != CullReason::culled) return reason;
  if (found.samples > 1 && from.program && from.program->usesCentroids()) return CullReason::multisampleState;
  found.program = from.program, found.matrix = from.matrix;
  if (e.repeats() > 1 || e.baseInstance != 0 || !from.position.terms.empty())
    if (const CullReason reason = planInstances(from, found); reason != CullReason::culled) return reason;
  return planMesh(from, found);
}

bool CulledDraws::choosePlace(Plan& plan) const {
  plan.rehearsed = plan.samples > 1 && !before_.isClear(plan.region);
  // A copy of a window may have its samples at other places in the pixels.
  return !plan.rehearsed || p_.shadow.target().framebuffer != 0;
}

bool CulledDraws::takesParts() {
  return p_.shadow.raster().program != 0 && programInUse().reason() == CullReason::culled;
}

CullReason CulledDraws::source(GLenum mode, const Elements& e, Source& found) {
  if (p_.shadow.raster().program != 0) return sourceOfProgram(mode, e, found);
  return p_.shadow.info.core ? CullReason::program : sourceOfFixedFunction(found);
}

CullReason CulledDraws::blendingOf(CulledProgram& program, const Varyings& varyings, GLenum mode,
                                   const Elements& e) {
  ShadowState& shadow = p_.shadow;
  const Opacity opacity = program.opacity(shadow.real, shadow.info.core, varyings);
  if (const CullReason reason = cullableBlending(shadow, opacity.opaque); reason != CullReason::culled)
    return reason;
  if (opacity.exact) return CullReason::culled;
  shadow.errors.keepPending();  // replacesColors() must not find errors pending
  const bool replaces = hasByteColors(shadow) && p_.pending.presenter.reader().replacesColors(shadow.real) &&
                        constants_.areOnes(shadow, program.known().program, opacity.ones, mode, e);
  return replaces ? CullReason::culled : CullReason::blend;
}

CullReason CulledDraws::sourceOfProgram(GLenum mode, const Elements& e, Source& found) {
  ShadowState& shadow = p_.shadow;
  CulledProgram& program = programInUse();
  if (program.reason() != CullReason::culled) return program.reason();
  const bool core = shadow.info.core;
  const bool blends = isOn(shadow.real, GL_BLEND);
  const InstanceAttributes instances = instanceAttributes(program.known().program, shadow.attributes());
  Varyings varyings;
  std::optional<LinearPosition> position =
      program.position(shadow.real, core, instances, blends ? &varyings : nullptr);
  if (!position) return CullReason::positions;
  if (blends)
    if (const CullReason reason = blendingOf(program, varyings, mode, e); reason != CullReason::culled)
      return reason;
  found.program = &program, found.matrix = {position->clipFromAttribute, position->magnitudes};
  found.components = position->components, found.position = std::move(*position);
  return findPositions(program, found.position.attribute, found.arrays, found.positions)
             ? CullReason::culled
             : CullReason::arrayState;
}

bool CulledDraws::findPositions(CulledProgram& program, const std::string& attribute,
                                const ArrayState*& arrays, const ArraySource*& positions) {
  ShadowState& shadow = p_.shadow;
  if (attribute == "gl_Vertex") {
    arrays = &shadow.arrays(), positions = &shadow.arrays().vertex;
    return true;
  }
  const ProgramAttribute* found = program.known().program.attribute(attribute);
  arrays = &shadow.attributes();
  positions = found ? arrayOf(shadow.attributes(), found->location) : nullptr;
  return positions != nullptr;
}

CullReason CulledDraws::sourceOfFixedFunction(Source& found) {
  const CullReason reason = cullableBlending(p_.shadow, false);
  return reason == CullReason::culled ? placeByFixedFunction(found) : reason;
}

CullReason CulledDraws::placeByFixedFunction(Source& found) {
  ShadowState& shadow = p_.shadow;
  if (fixedDiffers_) return CullReason::notTheSame;
  glm::dmat4 projection(1), modelview(1);
  shadow.real.GetDoublev(GL_PROJECTION_MATRIX, glm::value_ptr(projection));
  shadow.real.GetDoublev(GL_MODELVIEW_MATRIX, glm::value_ptr(modelview));
  const auto absolute = [](glm::dmat4 m) {
    for (int c = 0; c < 4; ++c) m[c] = glm::abs(m[c]);
    return m;
  };
  found.matrix = {projection * modelview, absolute(projection) * absolute(modelview)};
  found.arrays = &shadow.arrays(), found.positions = &shadow.arrays().vertex;
  return CullReason::culled;
}

CullReason CulledDraws::planMesh(const Source& from, Plan& found) {
  ShadowState& shadow = p_.shadow;
  const GLenum mode = found.mode;
  const Elements& e = found.elements;
  const ArrayState& arrays = *from.arrays;
  const ArraySource& positions = *from.positions;
  const int components = from.components;
  const bool inBuffers = positions.buffer && (!e.type || arrays.elements);
  // The program's memory is hashed at each draw, which must not slow down draws that are not worth culling.
  const bool always = shadow.settings.cull.draws == Culling::always;
  if (!positions.enabled || (!inBuffers && !always)) return CullReason::arrayState;
  ArrayState content;
  content.vertex = positions, content.vertex.size = std::min(positions.size, components);
  content.elements = arrays.elements;
  if (arrays.reason == Reason::deletedBuffer) return CullReason::deletedBuffer;
  if (foreignReason(content) != Reason::traced) return CullReason::foreignBuffer;
  const Assembly assembly = assemblyOf(shadow.real, shadow.raster().firstVertexProvokes, mode, e);
  if (assembly.restart && !inBuffers) return CullReason::arrayState;
  const Hash128 name = assembly.added(contentOf(shadow.real, content, mode, e));
  return planClusters(
      name, [&] { return CulledMesh::create(shadow.real, positions, components, content, assembly, e); },
      found);
}

CullReason CulledDraws::planClusters(const Hash128& name,
                                     const std::function<std::shared_ptr<CulledMesh>()>& make, Plan& found) {
  const bool always = p_.shadow.settings.cull.draws == Culling::always;
  if (!meshes_.contains(name)) forgetOld();
  Known& known = meshes_[name];
  if (known.frames == 0 || known.lastFrame != p_.clock.frame) ++known.frames;
  known.lastFrame = p_.clock.frame;
  if (!always && known.frames < kSteadyFrames) return CullReason::unsteady;
  if (!known.mesh && !known.refused) {
    known.mesh = make();
    known.refused = !known.mesh;
  }
  if (known.refused) return CullReason::arrayState;
  if (known.different) return CullReason::notTheSame;
  prepare(known.mesh);
  if (building_ == known.mesh || !known.mesh->isBuilt()) return CullReason::smallDraw;
  known.mesh->forgetPositions();
  found.mesh = known.mesh, found.known = &known;
  found.byClusters = found.units && areFewAndLarge(*found.units, *found.mesh);
  if (found.drawsAllInstances() && !found.byClusters) return found.apart;
  found.history = &historyOf(known, found);
  return CullReason::culled;
}

/// Builds the clusters: with cull = always at once, so that the first frame is culled, else in the
/// background.
void CulledDraws::prepare(const std::shared_ptr<CulledMesh>& mesh) {
  if (job_.busy() && job_.poll() != BackgroundJob::Outcome::none) building_.reset();
  if (building_ == mesh || mesh->isBuilt()) return;  // the job's result is not read while it runs
  if (p_.shadow.settings.cull.draws == Culling::always) return mesh->build();
  if (job_.busy()) return;
  building_ = mesh;
  job_.start([mesh](const std::atomic<bool>&) { mesh->build(); });
}

void CulledDraws::mapWindow(Plan& found) const {
  const ViewportState& viewport = p_.shadow.viewport();
  const TargetState& target = p_.shadow.target();
  const glm::ivec4 v = viewport.box, scissor = scissorBox(p_.shadow.real);
  glm::ivec2 lower = glm::max(glm::ivec2(v.x, v.y), glm::ivec2(scissor.x, scissor.y));
  glm::ivec2 upper = glm::min(glm::ivec2(v.x + v.z, v.y + v.w),
                              glm::ivec2(scissor.x, scissor.y) + glm::ivec2(scissor.z, scissor.w));
  found.samples = target.samples;
  // Mesa (22.3) draws samples up to one pixel outside the scissor box.
  if (found.samples > 1) lower -= 1, upper += 1;
  lower = glm::max(lower, glm::ivec2(0));
  if (target.size.x > 0) upper = glm::min(upper, target.size);
  found.region = {lower.x, lower.y, upper.x - lower.x, upper.y - lower.y};
  found.window.viewport = glm::dvec4(v.x - lower.x, v.y - lower.y, v.z, v.w);
  found.window.depthNear = viewport.depthNear, found.window.depthFar = viewport.depthFar;
  found.window.sampleReach = found.samples > 1 ? 0.5 : 0;  // anywhere in the pixel
  found.reversed = p_.shadow.raster().isReversed();
  if (!found.reversed) return;
  found.window.depthNear = 1 - viewport.depthNear, found.window.depthFar = 1 - viewport.depthFar;
}

CulledProgram& CulledDraws::programInUse() {
  const std::shared_ptr<const KnownProgram>& known = p_.shadow.programInUse().known;
  std::unique_ptr<CulledProgram>& program = programs_[known.get()];
  if (!program) program = std::make_unique<CulledProgram>(p_.shadow.real, known);
  return *program;
}

/// Forgets meshes that have not been drawn for long.
void CulledDraws::forgetOld() {
  const uint64_t now = p_.clock.frame;
  std::erase_if(meshes_, [&](const auto& entry) {
    const Known& known = entry.second;
    return (!building_ || known.mesh != building_) && known.lastFrame + kUnusedFrames < now;
  });
  std::erase_if(programs_, [&](const auto& entry) {
    const bool forgotten = entry.second->isForgotten();
    if (forgotten) entry.second->feedback().release(p_.shadow.real);
    return forgotten;
  });
}

}  // namespace gluray::gl
