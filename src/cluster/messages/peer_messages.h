// Occlusion queries between the ranks of a sort-last program (peers), sent between their workers. Any thread.
#pragma once
#include "cluster/messages/codec.h"
#include "render/tiles/drawn_part.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

namespace gluray::cluster {

/// The frame of the view that a snapshot shows, as the ranks of a program count: equally, up to a constant.
/// Snapshot::frame also counts pictures that only some ranks read.
inline uint64_t frameOf(const scene::Snapshot& snapshot) { return snapshot.swaps + snapshot.viewFrame; }

/// From one rank of a program to another.
struct PeerAddress {
  Hash128 program;  // of the name of its MPI job
  int32_t from = 0, to = 0;
};
/// To all workers: the sender traces for this rank of the program.
struct PeerJoins {
  static constexpr uint16_t kType = 20;
  PeerAddress address;  // `to` has no meaning
};
/// To all workers: the sender no longer traces for this rank.
struct PeerLeaves {
  static constexpr uint16_t kType = 21;
  PeerAddress address;
};
/// From now on, the sender has this scene, answers queries about it, and searches for scenes of other ranks
/// in the same view and frame.
struct SceneHeld {
  static constexpr uint16_t kType = 22;
  PeerAddress address;
  uint64_t round = 0;  // rises
  uint64_t frame = 0;  // frameOf(), as the sender's program counts
  uint64_t swaps = 0;  // Snapshot::swaps, the same
  glm::ivec4 viewport{0};
  glm::dmat4 clipFromEye{1}, eyeFromWorld{1}, viewFromWorld{1};
  glm::vec3 lower{1}, upper{0};  // of what light meets, in the space of viewFromWorld; lower > upper: nothing
  uint64_t changes = 0;          // as cluster/peers/part_changes.h counts them
  glm::dmat4 eyeFromLargest{1};  // of the surface with most triangles
  render::DrawnPart drawn;       // empty: the sender neither gives nor awaits depths
};
/// Depths of tiles, which the receiver's surfaces may lie behind.
struct TileDepths {
  static constexpr uint16_t kType = 28;
  PeerAddress address;
  uint64_t round = 0;                          // of the sender
  std::vector<int32_t> tiles;                  // numbers of the image's tiles, row by row
  std::vector<std::vector<std::byte>> packed;  // beside `tiles`, as of cluster/peers/tile_depths.h
};
/// Rays, in the receiver's world (cluster/peers/query_stream.h).
struct OcclusionQueries {
  static constexpr uint16_t kType = 23;
  PeerAddress address;
  uint64_t round = 0;  // of the receiver
  uint64_t id = 0;     // of the sender's, for the answer
  std::vector<std::byte> rays;
};
struct OcclusionReplies {
  static constexpr uint16_t kType = 24;
  PeerAddress address;
  uint64_t id = 0;
  bool refused = false;  // the scene is gone
  std::vector<std::byte> answers;
};
/// The sender traces its image without surfaces of the receiver, which has come late: it sends no depths.
struct NoDepths {
  static constexpr uint16_t kType = 29;
  PeerAddress address;
  uint64_t round = 0;  // of the sender
};
/// The sender has its image, and sends no more queries in this round.
struct DoneAsking {
  static constexpr uint16_t kType = 25;
  PeerAddress address;
};
/// The sender builds a scene of this view.
struct SceneComes {
  static constexpr uint16_t kType = 27;
  PeerAddress address;
  glm::ivec4 viewport{0};
};
/// Sign of life: the sender works on queries.
struct StillHere {
  static constexpr uint16_t kType = 26;
  PeerAddress address;
};

void fields(auto& archive, Like<PeerAddress> auto& value) {
  auto& [program, from, to] = value;
  archive(program, from, to);
}
void fields(auto& archive, Like<PeerJoins> auto& value) {
  auto& [address] = value;
  archive(address);
}
void fields(auto& archive, Like<PeerLeaves> auto& value) {
  auto& [address] = value;
  archive(address);
}
void fields(auto& archive, Like<render::DrawnPart> auto& value) {
  auto& [region, tiles, nearest, farthest] = value;
  archive(region, tiles, nearest, farthest);
}
void fields(auto& archive, Like<SceneHeld> auto& value) {
  auto& [address, round, frame, swaps, viewport, clipFromEye, eyeFromWorld, viewFromWorld, lower, upper,
         changes, eyeFromLargest, drawn] = value;
  archive(address, round, frame, swaps, viewport, clipFromEye, eyeFromWorld, viewFromWorld, lower, upper,
          changes, eyeFromLargest, drawn);
}
void fields(auto& archive, Like<TileDepths> auto& value) {
  auto& [address, round, tiles, packed] = value;
  archive(address, round, tiles, packed);
}
void fields(auto& archive, Like<NoDepths> auto& value) {
  auto& [address, round] = value;
  archive(address, round);
}
void fields(auto& archive, Like<OcclusionQueries> auto& value) {
  auto& [address, round, id, rays] = value;
  archive(address, round, id, rays);
}
void fields(auto& archive, Like<OcclusionReplies> auto& value) {
  auto& [address, id, refused, answers] = value;
  archive(address, id, refused, answers);
}
void fields(auto& archive, Like<DoneAsking> auto& value) {
  auto& [address] = value;
  archive(address);
}
void fields(auto& archive, Like<SceneComes> auto& value) {
  auto& [address, viewport] = value;
  archive(address, viewport);
}
void fields(auto& archive, Like<StillHere> auto& value) {
  auto& [address] = value;
  archive(address);
}

}  // namespace gluray::cluster
