// A snapshot with the additions of settings, as it is traced. Made once a frame by frame::Renderer.
#pragma once
#include "accel/rays/ray_kind.h"
#include "scene/snapshot.h"

#include <optional>

namespace gluray::render {

/// The snapshot with its ground (adr/0051) and its hidden objects. Without either, the unchanged snapshot.
/// The snapshot must outlive it.
class StagedScene {
 public:
  explicit StagedScene(const scene::Snapshot&);
  const scene::Snapshot& snapshot() const { return own_ ? *own_ : given_; }
  const accel::HiddenFrom& hidden() const { return hidden_; }

 private:
  void addGround();

  const scene::Snapshot& given_;
  std::optional<scene::Snapshot> own_;
  accel::HiddenFrom hidden_;
};

}  // namespace gluray::render
