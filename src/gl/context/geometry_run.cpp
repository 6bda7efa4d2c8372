#include "gl/context/geometry_run.h"

#include "gl/capture/mesh_builder.h"
#include "gl/capture/replay.h"
#include "gl/context/context.h"

#include <GL/gl.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace gluray::gl {

GeometryRun::GeometryRun(CapturedVertices captured, const SlotValues& finals,
                         std::vector<InheritedSlot> inherited, PrimitiveClass kind,
                         std::weak_ptr<ShareGroup> group)
    : captured_(std::move(captured)),
      layout_(captured_.layout),
      finalSlots_(layout_.mask & ~(bit(kPosition) | bit(kPositionW) | bit(kMaterialNumber))),
      finals_(finals),
      inherited_(std::move(inherited)),
      kind_(kind),
      group_(std::move(group)),
      triangles_(countTriangles(captured_)) {
  leftByList_ = slotsOfLastVertex();
  leadingMaterial_ = findLeadingMaterial();
  lastMaterial_ = materialOfLastVertex();
}

GeometryRun::GeometryRun(CapturedVertices captured, PrimitiveClass kind, std::weak_ptr<ShareGroup> group)
    : captured_(std::move(captured)),
      layout_(captured_.layout),
      finals_(initialSlotValues()),
      kind_(kind),
      group_(std::move(group)),
      triangles_(countTriangles(captured_)) {}

GeometryRun::~GeometryRun() { dropRealList(); }

void GeometryRun::dropRealList() {
  if (!realList_) return;
  if (const auto group = group_.lock()) group->discardRealList(realList_);
  realList_ = 0;
}

void GeometryRun::inherit(Context& context) {
  for (const InheritedSlot& inherited : inherited_) {
    const float* value = context.immediate.current(inherited.slot);
    const size_t bytes = sizeOf(inherited.slot) * sizeof(float);
    const uint32_t offset = layout_.offset[inherited.slot];
    if (std::memcmp(captured_.vertex(0) + offset, value, bytes) == 0) continue;
    for (uint32_t i = 0; i < inherited.vertices; ++i) std::memcpy(captured_.vertex(i) + offset, value, bytes);
    meshBuilt_ = false;
    dropRealList();
  }
}

// Mesa's lists keep materials between glBegin and glEnd as attributes of vertices: they are drawn with and
// stored even where they follow the colour, which the specification (GL 2.1, 2.14.3) rules out.
bool GeometryRun::setsFollowingMaterials(Context& context) const {
  const auto inside = [](const MaterialChange& change) { return !change.outside; };
  if (std::none_of(captured_.materials.begin(), captured_.materials.end(), inside)) return false;
  const scene::ColorMaterial following = readColorMaterial(context.real);
  const uint16_t front = parametersOf(following.front), back = parametersOf(following.back);
  return std::any_of(captured_.materials.begin(), captured_.materials.end(), [&](const MaterialChange& c) {
    return inside(c) && ((c.front & front) || (c.back & back));
  });
}

const KnownMesh& GeometryRun::mesh(Context& context) {
  if (meshBuilt_) return mesh_;
  // The mesh can replay the run too, unless the run has data that meshes do not hold.
  const bool reproducible = inherited_.empty() && (layout_.mask & ~kTracedSlots) == 0 &&
                            (captured_.indices.empty() || (captured_.primitives.size() == 1 &&
                                                           captured_.primitives[0].mode == GL_TRIANGLES));
  mesh_ = reproducible ? buildMesh(std::move(captured_)) : buildMesh(captured_);
  meshBuilt_ = true;
  ++context.counts.statistics.meshesBuilt;
  if (mesh_.mesh) context.counts.statistics.meshBytes += mesh_.mesh->sizeBytes;
  if (reproducible && mesh_.mesh) {
    captured_.vertices.release();
    captured_.indices.release();
    verticesReleased_ = true;
  }
  return mesh_;
}

const std::vector<Triangle>& GeometryRun::sample() {
  if (!sample_.empty()) return sample_;
  if (!meshBuilt_)
    sample_ = sampleTriangles(captured_);
  else if (mesh_.mesh)
    sample_ = sampleTriangles(*mesh_.mesh);
  return sample_;
}

void GeometryRun::rasterise(Context& context) {
  if (!realList_) {
    realList_ = context.real.GenLists(1);
    context.real.NewList(realList_, GL_COMPILE);
    if (verticesReleased_) {
      replay(context.real, *mesh_.mesh, captured_.primitives, captured_.materials);
      leftByList_ &= ~bit(kColor);  // meshes may round it in the last bit
    } else {
      replay(context.real, captured_);
    }
    context.real.EndList();
    // The real list now holds the vertices of lines and points, which need no mesh.
    if (kind_ != PrimitiveClass::surfaces && inherited_.empty() && !meshBuilt_) {
      captured_.vertices.release();
      verticesLost_ = true;
    }
  }
  context.real.CallList(realList_);
}

void GeometryRun::execute(Context& context) {
  if (context.immediate.insideBegin() && !captured_.primitives.empty())
    return context.errors.set(GL_INVALID_OPERATION);
  const auto setFinals = [&](SlotMask slots) {
    forEachSlot(slots, [&](Slot slot) { context.immediate.attribute(slot, finals_[slot].data()); });
  };
  if (captured_.primitives.empty()) {
    setFinals(finalSlots_);
    if (!captured_.materials.empty()) applyMaterials(context, captured_.materials.back());
    return;
  }
  context.immediate.closeRunIfOpen();
  if (continues_ && !context.clock.passesThrough() && !context.lists.executesNow())
    return drawContinued(context);
  CurrentValues& current = context.shadow.current;
  if (context.clock.passesThrough())
    if (const LeftByList leftByList = drawDirectly(context)) {
      setFinals(finalSlots_ & ~*leftByList);
      return leaveMaterials(context, nullptr);
    }
  if (context.lists.executesNow()) {
    draw(context);
    leaveExecuted(context);
    return leaveMaterials(context, nullptr);
  }
  const MaterialChange* leading = leadingMaterial();
  if (leading) applyMaterials(context, *leading);
  const CurrentValues::Held before = current.held();
  const LeftByList leftByList = draw(context);
  current.holdAgain(before);
  const ListEffect::Left& left = effect_.after(before.pending, before.due);
  const SlotMask again = leftByList ? slotsToRestore(left, before.pending, *leftByList) : 0;
  if (!current.holdsBack())
    setFinals(finalSlots_);
  else if (current.applyList(context.real, effect_, again))
    context.shadow.colorSet();
  leaveMaterials(context, leading && current.holdsMaterials() ? leading : nullptr);
}

/// The run, as its list is called.
class GeometryRun::RunDraw final : public DrawRequest {
 public:
  RunDraw(GeometryRun& run, Context& context) : run_(run), c_(context) {}
  Reason classifyState() override {
    Reason reason = c_.classifier.classify(run_.kind_);
    if (reason == Reason::traced && run_.setsFollowingMaterials(c_)) reason = Reason::colorMaterial;
    if (reason != Reason::traced || !run_.verticesLost_) return reason;
    return run_.kind_ == PrimitiveClass::points ? Reason::points : Reason::lines;
  }
  KnownMesh mesh() override { return run_.mesh(c_); }
  Reason classifyMesh(const KnownMesh& mesh) override {
    return c_.classifier.classify(mesh, run_.captured_.materials);
  }
  Reason trace(const KnownMesh& mesh) override {
    c_.filler.add(mesh.mesh, run_.layout_.mask, run_.captured_.materials);
    c_.counts.traced(DrawPath::list, run_.triangles_);
    c_.shadow.latch.drawn();
    return Reason::traced;
  }
  void meetPasses(PrimitiveClass primitive, Reason reason) override {
    c_.raster.meetPasses(
        primitive, reason, [&] { return run_.sample(); },
        [&]() -> const KnownMesh& { return run_.mesh(c_); });
  }
  Load load() override { return {DrawPath::list, run_.kind_, run_.triangles_}; }
  Fate make() override {
    run_.rasterise(c_);
    rasterised = true;
    c_.shadow.touch(kMaterial);
    return Fate::rasterised;
  }

  bool rasterised = false;

 private:
  GeometryRun& run_;
  Context& c_;
};

GeometryRun::LeftByList GeometryRun::draw(Context& context) {
  const std::lock_guard lock(mutex_);
  const DrawTimer timer(context.counts.kinds());
  context.passthrough.works();
  inherit(context);
  context.shadow.refresh(kDrawGroups);
  RunDraw request(*this, context);
  context.draws.submit(request);
  return request.rasterised ? LeftByList(leftByList_) : std::nullopt;
}

GeometryRun::LeftByList GeometryRun::drawDirectly(Context& context) {
  const std::lock_guard lock(mutex_);
  const DrawTimer timer(context.counts.kinds());
  if (!context.passthrough.takes(DrawPath::list, kind_, triangles_)) return std::nullopt;
  inherit(context);
  // Array draws leave the current attributes unchanged; the real list, which uses glBegin, does not.
  const SlotMask lost =
      layout_.mask & ~finalSlots_ & ~(bit(kPosition) | bit(kPositionW) | bit(kMaterialNumber));
  forEachSlot(lost, [&](Slot slot) { context.shadow.current.read(context.real, slot); });
  if (lost) context.shadow.latch.restore(context.real);
  rasterise(context);
  forEachSlot(lost, [&](Slot slot) { sendAttribute(context.real, slot, context.shadow.current[slot]); });
  return leftByList_;
}

}  // namespace gluray::gl
