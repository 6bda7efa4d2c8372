// Records when and where surfaces were drawn, and which clears have removed their depth since. A part of
// MultipassSurfaces and CoplanarSurfaces, GL thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

class ShadowState;

/// Where a surface is drawn.
struct DepthPlace {
  uint32_t framebuffer = 0;
  glm::ivec4 viewport{0};
  scene::Region region;  // the pixels that it may cover (ViewportState::region())
  bool operator==(const DepthPlace&) const = default;
};

/// The place of a draw in the current state.
DepthPlace depthPlaceOf(ShadowState& shadow);

/// A clear of all depths of `framebuffer` in `box`.
struct DepthClear {
  uint32_t framebuffer = 0;
  scene::Region box;
  /// Whether it clears all pixels that a surface drawn at `place` can have.
  bool removes(const DepthPlace& place) const;
};

/// A place, and the turn (see DepthHistory) in which a surface was drawn there.
struct DepthStamp {
  DepthPlace place;
  uint64_t turn = 0;
};

/// Counts turns, and records the last clears of each framebuffer. A turn ends with a clear of depth, or with
/// a frame that ends without a swap.
class DepthHistory {
 public:
  /// Number of turns for which surfaces are remembered if their depth is not cleared.
  static constexpr uint64_t kMaxTurns = 256;

  DepthStamp stamp(const DepthPlace& place) const { return {place, turn_}; }
  void nextTurn() { ++turn_; }
  void clear(const DepthClear& clear);
  /// Forgets the clears.
  void forget() { cleared_.clear(); }
  /// Whether a surface that was drawn there may have left depth where one is drawn `now`: not where all of
  /// that region was cleared since, as by programs that draw a part of the window again. Framebuffers may
  /// share their depth, so depth in another framebuffer counts unless that of `now` was cleared later.
  bool reaches(const DepthStamp& drawn, const DepthPlace& now) const;
  bool isOld(const DepthStamp& drawn) const { return drawn.turn + kMaxTurns < turn_; }

 private:
  uint64_t turn_ = 0;
  struct ClearedBox {
    scene::Region box;
    uint64_t turn;  // the first one after the clear
  };
  static constexpr size_t kMaxBoxes = 64;                          // of a framebuffer
  std::unordered_map<uint32_t, std::vector<ClearedBox>> cleared_;  // by framebuffer; the last clear last
};

}  // namespace gluray::gl
