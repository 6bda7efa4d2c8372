// Messages that gather the parts of a view from the ranks of a sort-last program (peers): the lowest rank
// that draws the view gathers the parts of the others. Sent between workers. Any thread.
#pragma once
#include "cluster/messages/peer_messages.h"

namespace gluray::cluster {

/// Properties of a rank's view in which parts must agree.
struct PartView {
  uint64_t frame = 0;  // Snapshot::frame
  glm::ivec4 viewport{0};
  glm::dmat4 clipFromEye{1}, eyeFromWorld{1};
  glm::dvec3 lower{1}, upper{0};  // of the surfaces, in eye space; lower > upper: not known
  Hash128 likeness;               // of all else: region, samples, depth range ...
  bool blends = false;            // it cannot be gathered
};
/// The sender has a part of this view, waits for its image, and looks for the parts of others.
struct PartHere {
  static constexpr uint16_t kType = 60;
  PeerAddress address;
  uint64_t round = 0;     // rises
  bool isAnswer = false;  // to a PartHere of this view: the sender still waits
  PartView view;
};
/// The sender no longer waits.
struct PartOver {
  static constexpr uint16_t kType = 66;
  PeerAddress address;
  std::vector<int32_t> with;  // ranks whose parts are in the sender's image
};
/// The sender's program is sending geometry, so that a part will follow.
struct PartComes {
  static constexpr uint16_t kType = 67;
  PeerAddress address;
};
/// To the lowest rank: the sender's part, for the receiver's image.
struct PartGiven {
  static constexpr uint16_t kType = 61;
  PeerAddress address;
  uint64_t round = 0;           // of the receiver
  uint64_t number = 0;          // TraceRequest::number
  std::vector<Hash128> arrays;  // that the snapshot names
  std::vector<std::byte> snapshot;
};
/// Answers PartGiven: the sender does not use the part.
struct PartDone {
  static constexpr uint16_t kType = 62;
  PeerAddress address;
  uint64_t round = 0;  // of PartGiven
};
/// Answers PartGiven, each time that the sender's program shows the image of all parts.
struct PartImage {
  static constexpr uint16_t kType = 65;
  PeerAddress address;
  uint64_t round = 0;      // of PartGiven
  bool finished = false;   // no further passes
  uint32_t missColor = 0;  // Image::missColor
  ImageShape shape;
  LayerCounts layers;
  std::vector<std::byte> pixels;  // of planesIn(shape)
};
/// The sender withdraws its part.
struct PartGone {
  static constexpr uint16_t kType = 63;
  PeerAddress address;
};
/// Sign of life: the sender waits for others, or works on parts.
struct PartAtWork {
  static constexpr uint16_t kType = 64;
  PeerAddress address;
};

void fields(auto& archive, Like<PartView> auto& value) {
  auto& [frame, viewport, clipFromEye, eyeFromWorld, lower, upper, likeness, blends] = value;
  archive(frame, viewport, clipFromEye, eyeFromWorld, lower, upper, likeness, blends);
}
void fields(auto& archive, Like<PartHere> auto& value) {
  auto& [address, round, isAnswer, view] = value;
  archive(address, round, isAnswer, view);
}
void fields(auto& archive, Like<PartOver> auto& value) {
  auto& [address, with] = value;
  archive(address, with);
}
void fields(auto& archive, Like<PartComes> auto& value) {
  auto& [address] = value;
  archive(address);
}
void fields(auto& archive, Like<PartGiven> auto& value) {
  auto& [address, round, number, arrays, snapshot] = value;
  archive(address, round, number, arrays, snapshot);
}
void fields(auto& archive, Like<PartDone> auto& value) {
  auto& [address, round] = value;
  archive(address, round);
}
void fields(auto& archive, Like<PartImage> auto& value) {
  auto& [address, round, finished, missColor, shape, layers, pixels] = value;
  archive(address, round, finished, missColor, shape, layers, pixels);
}
void fields(auto& archive, Like<PartGone> auto& value) {
  auto& [address] = value;
  archive(address);
}
void fields(auto& archive, Like<PartAtWork> auto& value) {
  auto& [address] = value;
  archive(address);
}

}  // namespace gluray::cluster
