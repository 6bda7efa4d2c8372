#include "gl/list.h"

#include "gl/handlers.h"
#include "gl/mesh_builder.h"
#include "gl/replay.h"
#include "gl/stub.h"

#include <cstring>

namespace gluray::gl {

FragmentOp::~FragmentOp() {
  if (const auto group = group_.lock()) group->discardRealList(realList_);
}

void FragmentOp::execute(Context& context) {
  // Called between glBegin and glEnd, it may hold what is legal there: the real OpenGL takes over and knows.
  context.beforeForward(context.insideBegin() ? Context::Flush::none : Context::Flush::all);
  context.real.CallList(realList_);
  context.touch(kAllGroups);
  context.matrixMode = 0;
}

GeometryRun::GeometryRun(Captured captured, const SlotValues& finals, std::vector<InheritedSlot> inherited,
                         PrimitiveClass kind, std::weak_ptr<ShareGroup> group)
    : captured_(std::move(captured)),
      layout_(captured_.layout),
      finalSlots_(layout_.mask & ~(bit(kPosition) | bit(kPositionW) | bit(kMaterialNumber))),
      finals_(finals),
      inherited_(std::move(inherited)),
      kind_(kind),
      group_(std::move(group)),
      triangles_(countTriangles(captured_)) {}

GeometryRun::GeometryRun(Captured captured, PrimitiveClass kind, std::weak_ptr<ShareGroup> group)
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
    const float* value = context.current(inherited.slot);
    const size_t bytes = sizeOf(inherited.slot) * sizeof(float);
    const uint32_t offset = layout_.offset[inherited.slot];
    if (std::memcmp(captured_.vertex(0) + offset, value, bytes) == 0) continue;
    for (uint32_t i = 0; i < inherited.vertices; ++i) std::memcpy(captured_.vertex(i) + offset, value, bytes);
    meshBuilt_ = false;
    dropRealList();
  }
}

const KnownMesh& GeometryRun::mesh(Context& context) {
  if (meshBuilt_) return mesh_;
  // The mesh replays the run as well, unless the run has what meshes do not carry.
  const bool reproducible = inherited_.empty() && (layout_.mask & ~kTracedSlots) == 0 &&
                            (captured_.indices.empty() || (captured_.primitives.size() == 1 &&
                                                           captured_.primitives[0].mode == GL_TRIANGLES));
  mesh_ = reproducible ? buildMesh(std::move(captured_)) : buildMesh(captured_);
  meshBuilt_ = true;
  ++context.statistics.meshesBuilt;
  if (mesh_.mesh) context.statistics.meshBytes += mesh_.mesh->sizeBytes;
  if (reproducible && mesh_.mesh) {
    captured_.vertices.release();
    captured_.indices.release();
    verticesReleased_ = true;
  }
  return mesh_;
}

void GeometryRun::rasterise(Context& context) {
  if (!realList_) {
    realList_ = context.real.GenLists(1);
    context.real.NewList(realList_, GL_COMPILE);
    if (verticesReleased_)
      replay(context.real, *mesh_.mesh, captured_.primitives, captured_.materials);
    else
      replay(context.real, captured_);
    context.real.EndList();
    // The real list holds the vertices of lines and points; nobody will ask for a mesh of them.
    if (kind_ != PrimitiveClass::surfaces && inherited_.empty()) captured_.vertices.release();
  }
  context.real.CallList(realList_);
}

/// Executes a recorded step as if no list were being compiled. The stream must be empty, and is again
/// afterwards.
template <class F>
void Context::runDetached(F&& body) {
  auto compiled = std::exchange(list_, nullptr);
  updateAttention();
  const auto restore = [&] {
    list_ = std::move(compiled);
    startRun();
  };
  try {
    body();
    if (runOpen_) closeRun();
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

void Context::append(std::unique_ptr<ListOp>& op) {
  if (!op) return;
  if (!list_) return std::exchange(op, nullptr)->execute(*this);
  if (!stream_.empty() || stream_.layout().mask != bit(kPosition)) closeRun();
  list_->makeRoom();
  ListOp& appended = *op;
  list_->append(std::move(op));
  if (executing()) runDetached([&] { appended.execute(*this); });
}

void Context::recordRun() {
  Captured run = stream_.take();
  if (run.empty() && run.layout.mask == bit(kPosition)) return;
  SlotValues finals = current_.all();
  for (int s = kNormal; s < kSlotCount; ++s)
    if (run.layout.has(static_cast<Slot>(s)))
      std::memcpy(finals[static_cast<size_t>(s)].data(), stream_.get(run.layout, static_cast<Slot>(s)),
                  sizeOf(static_cast<Slot>(s)) * 4);
  ListOp* recorded = nullptr;
  try {
    list_->makeRoom();
    auto op = std::make_unique<GeometryRun>(std::move(run), finals, std::move(inherited_), runClass_, group_);
    recorded = op.get();
    list_->append(std::move(op));
  } catch (...) {
    stream_.captured() = std::move(run);  // not yet moved from: stepAside() gives it to the real OpenGL
    throw;
  }
  inherited_.clear();
  if (executing()) runDetached([&] { recorded->execute(*this); });
}

void Context::newList(GLuint name, GLenum mode) {
  if (name == 0) return setError(GL_INVALID_VALUE);
  if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return setError(GL_INVALID_ENUM);
  if (compiling() || insideBegin()) return setError(GL_INVALID_OPERATION);
  if (runOpen_) closeRun();
  list_ = std::make_shared<DisplayList>();
  listName_ = name;
  listMode_ = mode;
  startRun();
}

void Context::endList() {
  if (!compiling() || insideBegin()) return setError(GL_INVALID_OPERATION);
  recordRun();
  group_->lists.put(listName_, list_);
  list_.reset();
  listName_ = 0;
  listMode_ = 0;
  stream_.start(bit(kPosition), current_.all());
  updateAttention();
}

void Context::callList(GLuint name) {
  constexpr int kDeepest = 64;  // GL_MAX_LIST_NESTING: also what ends lists that call themselves
  const auto list = group_->lists.find(name);
  if (!list || listDepth_ >= kDeepest) return;
  if (runOpen_ && !insideBegin()) closeRun();
  ++listDepth_;
  try {
    list->execute(*this);
  } catch (...) {
    --listDepth_;
    throw;
  }
  --listDepth_;
}

void Context::execute(GeometryRun& run) {
  if (insideBegin() && !run.primitives().empty()) return setError(GL_INVALID_OPERATION);
  if (!run.primitives().empty()) {
    if (runOpen_) closeRun();
    if (!direct_ || !drawRunDirectly(run)) drawListRun(run);
  }
  for (int s = kNormal; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (run.finalSlots() & bit(slot)) attribute(slot, run.finals()[slot].data());
  }
  if (!run.materials().empty()) applyMaterial(run.materials().back());
}

void Context::drawListRun(GeometryRun& run) {
  const std::lock_guard lock(run.mutex());
  const DrawTimer timer(kinds());
  works();
  run.inherit(*this);
  refresh(kDrawGroups);
  Reason reason = triage(run.kind());
  if (reason == Reason::traced) {
    reason = attempt([&] {
      const KnownMesh& known = run.mesh(*this);
      const Reason fine = triage(known, run.materials());
      if (fine == Reason::traced) addInstance(known.mesh, run.slots(), run.materials());
      return fine;
    });
  }
  if (reason == Reason::traced) return countTraced(DrawPath::list, run.triangles());
  if (mayMeetPasses(run.kind()) || isPass(run.kind(), reason))
    protect([&] {
      const KnownMesh& known = run.mesh(*this);
      if (known.mesh) meetPasses(sampleTriangles(*known.mesh));
      if (isPass(run.kind(), reason)) rememberPass(known);
    });
  countRaster(reason, DrawPath::list, run.kind(), run.triangles());
  beforeRasterDraw(run.kind());
  run.rasterise(*this);
  // The real OpenGL now has the run's last attributes current: they are sent again where ours differ.
  current_.lost(run.slots() & ~(bit(kPosition) | bit(kPositionW) | bit(kMaterialNumber)));
  touch(kMaterial);
}

void Context::applyMaterial(const MaterialChange& change) {
  const auto each = [&](GLenum face, const scene::Material& m, uint16_t set) {
    if (set & MaterialChange::ambient) material(face, GL_AMBIENT, &m.ambient.x);
    if (set & MaterialChange::diffuse) material(face, GL_DIFFUSE, &m.diffuse.x);
    if (set & MaterialChange::specular) material(face, GL_SPECULAR, &m.specular.x);
    if (set & MaterialChange::emission) material(face, GL_EMISSION, &m.emission.x);
    if (set & MaterialChange::shininess) material(face, GL_SHININESS, &m.shininess);
  };
  each(GL_FRONT, change.values.front, change.front);
  each(GL_BACK, change.values.back, change.back);
}

}  // namespace gluray::gl
