// Display lists: recorded whole, replayed by us. GL thread; lists of a share group may be called from
// several.
#pragma once
#include "gl/context.h"

#include <memory>
#include <mutex>
#include <vector>

namespace gluray::gl {

/// One recorded step of a list.
class ListOp {
 public:
  virtual ~ListOp() = default;
  virtual void execute(Context& context) = 0;
};

/// A recorded call with its arguments. `anywhere`: it is legal between glBegin and glEnd, where the list may
/// be called, too.
template <class Call>
class CallOp final : public ListOp {
 public:
  CallOp(Call call, bool anywhere) : call_(std::move(call)), anywhere_(anywhere) {}
  void execute(Context& context) override {
    if (!anywhere_ && context.insideBegin()) return context.setError(GL_INVALID_OPERATION);
    call_(context);
  }

 private:
  Call call_;
  bool anywhere_;
};

/// Commands that we do not model, compiled by the real OpenGL into a list of its own.
class FragmentOp final : public ListOp {
 public:
  FragmentOp(GLuint realList, std::weak_ptr<ShareGroup> group)
      : realList_(realList), group_(std::move(group)) {}
  ~FragmentOp() override;
  void execute(Context& context) override;

 private:
  GLuint realList_;
  std::weak_ptr<ShareGroup> group_;
};

class DisplayList {
 public:
  /// After this, one append() does not allocate.
  void makeRoom() {
    if (ops_.size() == ops_.capacity()) ops_.reserve(ops_.size() * 2 + 4);
  }
  void append(std::unique_ptr<ListOp> op) { ops_.push_back(std::move(op)); }
  void execute(Context& context) const {
    for (const auto& op : ops_) op->execute(context);
  }

 private:
  std::vector<std::unique_ptr<ListOp>> ops_;
};

/// A run of glBegin/glEnd pairs inside a list, with the attributes it leaves behind.
class GeometryRun final : public ListOp {
 public:
  GeometryRun(Captured captured, const SlotValues& finals, std::vector<InheritedSlot> inherited,
              PrimitiveClass kind, std::weak_ptr<ShareGroup> group);
  /// A draw from arrays: leaves the current attributes alone.
  GeometryRun(Captured captured, PrimitiveClass kind, std::weak_ptr<ShareGroup> group);
  ~GeometryRun() override;
  void execute(Context& context) override { context.execute(*this); }

  /// Held while the run is drawn: contexts of several threads may call the list.
  std::mutex& mutex() { return mutex_; }
  PrimitiveClass kind() const { return kind_; }
  const std::vector<Primitive>& primitives() const { return captured_.primitives; }
  const std::vector<MaterialChange>& materials() const { return captured_.materials; }
  SlotMask slots() const { return layout_.mask; }
  /// Attributes that the run leaves current, and their values.
  SlotMask finalSlots() const { return finalSlots_; }
  const SlotValues& finals() const { return finals_; }
  uint64_t triangles() const { return triangles_; }

  /// Gives inherited slots the caller's values.
  void inherit(Context& context);
  /// The mesh of its surfaces, built at the first call.
  const KnownMesh& mesh(Context& context);
  /// Draws it with the real OpenGL, from a real list made at the first call.
  void rasterise(Context& context);

 private:
  void dropRealList();

  std::mutex mutex_;
  Captured captured_;
  VertexLayout layout_;
  SlotMask finalSlots_ = 0;
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
