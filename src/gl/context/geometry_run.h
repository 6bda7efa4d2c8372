// Captured vertices in a display list. GL threads: several may call a list of their share group.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/capture/list_values.h"
#include "gl/context/list.h"
#include "gl/history/sampled_surfaces.h"
#include "gl/sharing/share_group.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace gluray::gl {

/// Calls Immediate::material for every parameter that `change` sets.
void applyMaterials(Context& context, const MaterialChange& change);

/// A run of glBegin/glEnd pairs inside a list, with the attribute values it leaves current.
class GeometryRun final : public ListOp {
 public:
  GeometryRun(CapturedVertices captured, const SlotValues& finals, std::vector<InheritedSlot> inherited,
              PrimitiveClass kind, std::weak_ptr<ShareGroup> group);
  /// An array draw: leaves the current attributes unchanged.
  GeometryRun(CapturedVertices captured, PrimitiveClass kind, std::weak_ptr<ShareGroup> group);
  ~GeometryRun() override;
  /// What it does to current values. Initially they stay as they are.
  void setEffect(ListEffect effect) { effect_ = std::move(effect); }
  /// Marks the run as a later draw of a multi-draw, whose first draw alone stores current values.
  void setContinues() { continues_ = true; }
  /// Draws the run, traced or rasterised, and makes its last attributes current.
  void execute(Context& context) override;

 private:
  class RunDraw;
  /// Makes the attributes after its last vertex current, as Mesa does when it executes a list's commands
  /// while it compiles them.
  void leaveExecuted(Context& context);
  /// The same for materials. `again`: those before the first vertex, if Mesa stores them again.
  void leaveMaterials(Context& context, const MaterialChange* again);
  /// Slots that must be stored again after the real list has drawn the run: not those with the values that it
  /// leaves. `pending`: values were held back before it, and not yet stored.
  SlotMask slotsToRestore(const ListEffect::Left& left, bool pending, SlotMask leftByList) const;
  /// leftByList_ of a run that the real list has drawn; nullopt: it has not.
  using LeftByList = std::optional<SlotMask>;
  LeftByList draw(Context& context);
  /// Draws it as a later draw of a multi-draw.
  void drawContinued(Context& context);
  /// Rasterises the run in a passthrough frame. Nullopt if it is too large for that: call draw().
  LeftByList drawDirectly(Context& context);
  /// The materials that are set before its first glBegin, if any.
  const MaterialChange* leadingMaterial() const;
  uint32_t findLeadingMaterial() const;
  uint32_t lastVertex() const;
  /// The number of the last vertex's materials; 0: none are set.
  uint32_t materialOfLastVertex() const;
  /// Those of finalSlots_ that have the value of the last vertex, which the real list leaves current.
  SlotMask slotsOfLastVertex() const;
  /// Fills inherited slots with the caller's current values.
  void inherit(Context& context);
  /// Whether it has materials between glBegin and glEnd that follow the current colour now.
  bool setsFollowingMaterials(Context& context) const;
  /// The mesh of its surfaces, built at the first call.
  const KnownMesh& mesh(Context& context);
  /// Some of its triangles, found at the first call.
  const std::vector<Triangle>& sample();
  /// Draws it with the real OpenGL, from a real list made at the first call.
  void rasterise(Context& context);
  void dropRealList();

  std::mutex mutex_;  // held while the run is drawn: contexts of several threads may call the list
  CapturedVertices captured_;
  VertexLayout layout_;
  SlotMask finalSlots_ = 0;  // attributes that the run leaves current, with values finals_
  SlotMask leftByList_ = 0;  // those of them that the real list has left current; read it under the mutex
  SlotValues finals_;
  ListEffect effect_;
  uint32_t leadingMaterial_ = 0;  // its number; 0: none
  uint32_t lastMaterial_ = 0;     // that of the last vertex
  bool continues_ = false;        // a later draw of a multi-draw
  std::vector<InheritedSlot> inherited_;
  PrimitiveClass kind_;
  std::weak_ptr<ShareGroup> group_;
  uint64_t triangles_;
  KnownMesh mesh_;
  bool meshBuilt_ = false;
  std::vector<Triangle> sample_;
  bool verticesReleased_ = false;  // to mesh_
  bool verticesLost_ = false;      // to realList_
  GLuint realList_ = 0;
};

}  // namespace gluray::gl
