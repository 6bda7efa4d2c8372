// Occlusion queries to surfaces of a view in other processes: each rank of a sort-last program has a part of
// the scene. Implemented by cluster/peers, called on all tracing threads.
#pragma once
#include "accel/rays/bounds.h"
#include "accel/rays/occlusion.h"
#include "accel/rays/ray_kind.h"
#include "base/image.h"
#include "render/tiles/drawn_part.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>

namespace gluray::render {

struct FrameData;
struct HiddenPixels;
struct Tile;

/// Transmittance of a packet's rays so far, by lane: `grey` or `colored`; the other is null.
struct Passing {
  float* grey = nullptr;
  glm::vec3* colored = nullptr;
};

/// The rays of one packet, after the query to this process's surfaces.
struct RemoteQuery {
  const int32_t* valid;              // -1: the lane counts, 0: it does not
  const accel::OcclusionRays& rays;  // unchanged origins and directions; tFar of lanes that are not blocked
  accel::RayKind kind;               // shadow or occlusion
  const glm::vec3* lamp = nullptr;   // eye space: position of the light whose lamps are ignored; may be null
};

class RemoteSurfaces {
 public:
  virtual ~RemoteSurfaces() = default;
  /// Finds the other processes with a part of this view; may wait for them. Called after the acceleration
  /// structures are built, and before anything is traced.
  virtual void begin(const FrameData&) = 0;
  /// Called instead of begin() if this process has no surface of the view.
  virtual void beginEmpty(const scene::Snapshot&) = 0;
  /// After begin(): bounds of the scene in all processes, in the space of SecondaryScene::viewFromWorld.
  virtual accel::Bounds bounds() const noexcept = 0;
  /// After begin(): whether surfaces of any process have moved relative to others, or changed, since the last
  /// moving frame of the view.
  virtual bool changed() const noexcept = 0;
  /// Returns bit i if surfaces of other processes, or of this process (`blocked`), block ray i. Multiplies
  /// the transmittance. A tile may be traced twice: the first time, answers are missing, and rays count as
  /// unblocked.
  virtual uint32_t occluded(const RemoteQuery&, uint32_t blocked, Passing) noexcept = 0;
  /// Sets the lanes that were blocked in the corresponding query of the tile's first trace. Returns false if
  /// the query must be repeated, because surfaces are translucent or this is the first trace.
  virtual bool recall(uint32_t& blocked) noexcept = 0;
  /// Whether this thread traces its tile a second time.
  virtual bool isReplaying() const noexcept = 0;
  /// Whether the tile of this thread has been given to exchangeDepths() before.
  virtual bool hasDepths() const noexcept = 0;
  /// With FrameData::seen: the depths of this thread's tile are in the image. Gives them to the processes
  /// whose surfaces they may hide. Returns true if depths of others are to come: then the source hands the
  /// tile out again, once they are there or cannot be awaited any longer.
  virtual bool exchangeDepths(const Tile&, const Image&) noexcept = 0;
  /// The pixels of this thread's tile that other processes hide for sure, the same each time.
  virtual const HiddenPixels& hidden(const Tile&, const Image&) noexcept = 0;
  /// Called when all tiles are traced. Calls `whole` unless the image must be traced again; then answers
  /// other processes until this process has another frame to trace.
  virtual void hold(const std::function<void()>& whole) noexcept = 0;
};

/// Returns bit i if a surface of this or another process blocks ray i. `filter` filters the surfaces of this
/// process and owns `passing`, which volumes of the view dim, too. Otherwise like accel::World::occluded.
uint32_t occludedAnywhere(const FrameData&, const int32_t* valid, accel::OcclusionRays&, accel::RayKind,
                          const accel::OccluderFilter* filter, Passing passing,
                          const glm::vec3* lamp = nullptr) noexcept;
/// The same for surfaces of this process alone.
uint32_t occludedHere(const FrameData&, const int32_t* valid, accel::OcclusionRays&, accel::RayKind,
                      const accel::OccluderFilter* filter, Passing passing) noexcept;

}  // namespace gluray::render
