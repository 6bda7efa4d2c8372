// Messages with what the ranks of a program spend, for the report that its rank 0 writes. Any thread.
#pragma once
#include "cluster/messages/codec.h"
#include "cluster/messages/peer_messages.h"

namespace gluray::cluster {

/// What a rank of a program has spent since it connected to its worker. Times are sums over its images in
/// seconds, and means over the worker's tracing threads.
struct RankFigures {
  enum class State : uint8_t { connected, ended, lost };
  int32_t rank = 0;
  State state = State::connected;
  std::string host;         // of its worker; empty: unknown
  uint64_t images = 0;      // that its worker made
  double traceSeconds = 0;  // from an image's request to its end, structures included
  double eyeSeconds = 0;    // rays from the viewer, of images with light across ranks
  double lightSeconds = 0;  // all shading of these
  // Waiting for the scenes, the depths and the answers about light of other ranks.
  double scenesSeconds = 0, depthsSeconds = 0, answersSeconds = 0;
  uint64_t bytesSent = 0, bytesReceived = 0;  // between its worker and those of the other ranks
  uint64_t memoryBytes = 0;                   // resident in its worker

  double waitSeconds() const { return scenesSeconds + depthsSeconds + answersSeconds; }
};

template <>
inline constexpr auto kLast<RankFigures::State> = RankFigures::State::lost;

/// To the worker of a program's rank 0: the figures of the rank `address.from`.
struct FiguresGiven {
  static constexpr uint16_t kType = 30;
  PeerAddress address;
  RankFigures figures;
};
/// From a program: requests FiguresKnown.
struct FiguresQuestion {
  static constexpr uint16_t kType = 7;
};
/// From a program: it ends by itself.
struct ProgramEnds {
  static constexpr uint16_t kType = 8;
};
/// From a worker, answers FiguresQuestion. Rank 0 gets the figures of all ranks that have connected, in
/// order, the others their own.
struct FiguresKnown {
  static constexpr uint16_t kType = 105;
  std::vector<RankFigures> ranks;
};

void fields(auto& archive, Like<RankFigures> auto& value) {
  auto& [rank, state, host, images, traceSeconds, eyeSeconds, lightSeconds, scenesSeconds, depthsSeconds,
         answersSeconds, bytesSent, bytesReceived, memoryBytes] = value;
  archive(rank, state, host, images, traceSeconds, eyeSeconds, lightSeconds, scenesSeconds, depthsSeconds,
          answersSeconds, bytesSent, bytesReceived, memoryBytes);
}
void fields(auto& archive, Like<FiguresGiven> auto& value) {
  auto& [address, figures] = value;
  archive(address, figures);
}
void fields(auto&, Like<FiguresQuestion> auto&) {}
void fields(auto&, Like<ProgramEnds> auto&) {}
void fields(auto& archive, Like<FiguresKnown> auto& value) {
  auto& [ranks] = value;
  archive(ranks);
}

}  // namespace gluray::cluster
