// The vertices in a display list. GL thread; lists of a share group may be called from several.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/lists/list.h"
#include "gl/share_group.h"

#include <memory>
#include <mutex>
#include <vector>

namespace gluray::gl {

/// glMaterial for every parameter that `change` holds.
void applyMaterials(Context& context, const MaterialChange& change);

/// A run of glBegin/glEnd pairs inside a list, with the attributes it leaves behind.
class GeometryRun final : public ListOp {
 public:
  GeometryRun(CapturedVertices captured, const SlotValues& finals, std::vector<InheritedSlot> inherited,
              PrimitiveClass kind, std::weak_ptr<ShareGroup> group);
  /// A draw from arrays: leaves the current attributes alone.
  GeometryRun(CapturedVertices captured, PrimitiveClass kind, std::weak_ptr<ShareGroup> group);
  ~GeometryRun() override;
  /// Draws it, traced or by the real OpenGL, and leaves its last attributes current.
  void execute(Context& context) override;

 private:
  void draw(Context& context);
  /// In a frame that is left to the real OpenGL. False: draw() it.
  bool drawDirectly(Context& context);
  /// Gives inherited slots the caller's values.
  void inherit(Context& context);
  /// The mesh of its surfaces, built at the first call.
  const KnownMesh& mesh(Context& context);
  /// Draws it with the real OpenGL, from a real list made at the first call.
  void rasterise(Context& context);
  void dropRealList();

  std::mutex mutex_;  // held while the run is drawn: contexts of several threads may call the list
  CapturedVertices captured_;
  VertexLayout layout_;
  SlotMask finalSlots_ = 0;  // attributes that it leaves current, and their values
  SlotValues finals_;
  std::vector<InheritedSlot> inherited_;
  PrimitiveClass kind_;
  std::weak_ptr<ShareGroup> group_;
  uint64_t triangles_;
  KnownMesh mesh_;
  bool meshBuilt_ = false;
  bool verticesReleased_ = false;
  GLuint realList_ = 0;
};

}  // namespace gluray::gl
