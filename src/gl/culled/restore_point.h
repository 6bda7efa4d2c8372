// Saves and restores the pixels that a draw may change. A part of CulledDraws, GL thread.
#pragma once
#include "gl/draws/raster_draws.h"
#include "gl/pending/pending_batch.h"
#include "gl/shadow/shadow_state.h"
#include "scene/snapshot.h"

#include <optional>

namespace gluray::gl {

class RestorePoint {
 public:
  /// The arguments must outlive it.
  RestorePoint(ShadowState& shadow, PendingBatch& pending, const RasterDraws& raster)
      : shadow_(shadow), pending_(pending), raster_(raster) {}

  /// Whether `region` is only cleared, so that a clear can restore it.
  bool isClear(const scene::Region& region) const;
  /// Saves `region`. Call before the draw, after RasterDraws::before(). Returns false on failure.
  bool keep(const scene::Region& region);
  /// Restores the pixels. Changes no state.
  void putBack();

 private:
  void clear(const ClearedTarget& as);

  ShadowState& shadow_;
  PendingBatch& pending_;
  const RasterDraws& raster_;
  scene::Region region_;
  std::optional<ClearedTarget> clear_;  // the region's clear values; nullopt: its pixels were copied
};

}  // namespace gluray::gl
