// How the ranks of a sort-last program, peers, bring the parts of a view together: the lowest rank that draws
// it gathers those of the others. All go from worker to worker. Any thread.
#pragma once
#include "dist/messages/peer_messages.h"

namespace gluray::dist {

/// What a rank shows, as far as parts must agree in it.
struct PartView {
  uint64_t frame = 0;  // frameOf()
  glm::ivec4 viewport{0};
  glm::dmat4 clipFromEye{1}, eyeFromWorld{1};
  Hash128 likeness;     // of all else: region, samples, depth range ...
  bool blends = false;  // it cannot be gathered
};
/// The sender has a part of this view, and looks for those of others.
struct PartHere {
  static constexpr uint16_t kType = 60;
  PeerAddress address;
  uint64_t round = 0;    // rises
  uint32_t ordinal = 0;  // of the frame's scenes in this viewport
  PartView view;
};
/// To the lowest rank: the sender's part belongs to its picture.
struct PartGiven {
  static constexpr uint16_t kType = 61;
  PeerAddress address;
  uint64_t round = 0;           // of the receiver
  uint64_t number = 0;          // TraceRequest::number
  std::vector<Hash128> arrays;  // that the snapshot names
  std::vector<std::byte> snapshot;
};
/// Answers PartGiven: the part belongs to no picture.
struct PartDone {
  static constexpr uint16_t kType = 62;
  PeerAddress address;
  uint64_t round = 0;  // of PartGiven
};
/// Answers PartGiven, each time that the sender's program shows the picture of all parts.
struct PartPicture {
  static constexpr uint16_t kType = 65;
  PeerAddress address;
  uint64_t round = 0;      // of PartGiven
  bool finished = false;   // it will not become better
  uint32_t missColor = 0;  // Image::missColor
  ImageShape shape;
  LayerCounts layers;
  std::vector<std::byte> pixels;  // of planesIn(shape)
};
/// The sender's part does not belong to the picture any more.
struct PartGone {
  static constexpr uint16_t kType = 63;
  PeerAddress address;
};
/// The sender waits for others, or is at work on parts.
struct PartAtWork {
  static constexpr uint16_t kType = 64;
  PeerAddress address;
};

void fields(auto& archive, Like<PartView> auto& value) {
  auto& [frame, viewport, clipFromEye, eyeFromWorld, likeness, blends] = value;
  archive(frame, viewport, clipFromEye, eyeFromWorld, likeness, blends);
}
void fields(auto& archive, Like<PartHere> auto& value) {
  auto& [address, round, ordinal, view] = value;
  archive(address, round, ordinal, view);
}
void fields(auto& archive, Like<PartGiven> auto& value) {
  auto& [address, round, number, arrays, snapshot] = value;
  archive(address, round, number, arrays, snapshot);
}
void fields(auto& archive, Like<PartDone> auto& value) {
  auto& [address, round] = value;
  archive(address, round);
}
void fields(auto& archive, Like<PartPicture> auto& value) {
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

}  // namespace gluray::dist
