// Surfaces of a view that other processes hold: the ranks of a sort-last program have a part of the scene
// each. They block light as this process's own surfaces do. Implemented by cluster/peers, asked on all
// tracing threads.
#pragma once
#include "accel/rays/bounds.h"
#include "accel/rays/occlusion.h"
#include "accel/rays/ray_kind.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>

namespace gluray::render {

struct FrameData;

/// What of a packet's rays has passed so far, by lane: `grey` or `colored`, the other is null.
struct Passing {
  float* grey = nullptr;
  glm::vec3* colored = nullptr;
};

/// The rays of one packet, which this process's surfaces have been asked about.
struct RemoteQuery {
  const int32_t* valid;              // -1: the lane counts, 0: it does not
  const accel::OcclusionRays& rays;  // origins and directions as they were asked; tFar of lanes not blocked
  accel::RayKind kind;               // shadow or occlusion
  const glm::vec3* lamp =
      nullptr;  // eye space: where the light stands whose lamps do not hide it; may be null
};

class RemoteSurfaces {
 public:
  virtual ~RemoteSurfaces() = default;
  /// Before anything is traced, when FrameData::remote is set and the structures are built: finds the others
  /// that hold a part of this view. May wait for them.
  virtual void begin(const FrameData&) = 0;
  /// In place of begin(), where this process has no surface of the view.
  virtual void beginEmpty(const scene::Snapshot&) = 0;
  /// After begin(): of what light meets in all processes, in the space of Surroundings::viewFromWorld.
  virtual accel::Bounds bounds() const noexcept = 0;
  /// After begin(): whether surfaces of any process have moved against others, or changed, since the last
  /// moving frame of the view.
  virtual bool changed() const noexcept = 0;
  /// Bit i: surfaces elsewhere, or those of this process (`blocked`), block ray i. Multiplies what passes.
  /// A tile may be traced twice: answers are not there the first time, and its rays count as free.
  virtual uint32_t occluded(const RemoteQuery&, uint32_t blocked, Passing) noexcept = 0;
  /// The lanes that are blocked, of the query that this thread made at the same place when it traced the tile
  /// for the first time. False: it must be made again, because parts of rays pass, or this is the first time.
  virtual bool recall(uint32_t& blocked) noexcept = 0;
  /// Whether this thread traces its tile for the second time.
  virtual bool isReplaying() const noexcept = 0;
  /// All tiles are traced. Calls `whole` unless the picture must be traced anew; then answers others until
  /// this process has something else to trace.
  virtual void hold(const std::function<void()>& whole) noexcept = 0;
};

/// What blocks a packet's rays, in this process and elsewhere: bit i, ray i. `filter` is asked about surfaces
/// of this process; `passing` belongs to it. Otherwise as accel::World::occluded.
uint32_t occludedAnywhere(const FrameData&, const int32_t* valid, accel::OcclusionRays&, accel::RayKind,
                          const accel::OccluderFilter* filter, Passing passing,
                          const glm::vec3* lamp = nullptr) noexcept;

}  // namespace gluray::render
