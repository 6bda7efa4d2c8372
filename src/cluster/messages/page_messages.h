// Messages that transfer pages of large meshes from the rank with the geometry. Any thread.
#pragma once
#include "cluster/messages/codec.h"

#include <string>

namespace gluray::cluster {

/// To the owner of a page: the sender needs it.
struct PageWanted {
  static constexpr uint16_t kType = 13;
  Hash128 id;
};
/// Answers PageWanted.
struct PageGiven {
  static constexpr uint16_t kType = 14;
  Hash128 id;
  std::vector<std::byte> bytes;  // empty: the owner no longer has it
};
/// From a worker's page maker to the rank itself: a program's snapshot in pages.
struct PagesMade {
  static constexpr uint16_t kType = 15;
  uint64_t number = 0;  // of the job
  std::string error;    // empty: there was none
  std::vector<std::byte> snapshot;
  std::vector<Hash128> arrays;  // that the snapshot names
};

void fields(auto& archive, Like<PageWanted> auto& value) {
  auto& [id] = value;
  archive(id);
}
void fields(auto& archive, Like<PageGiven> auto& value) {
  auto& [id, bytes] = value;
  archive(id, bytes);
}
void fields(auto& archive, Like<PagesMade> auto& value) {
  auto& [number, error, snapshot, arrays] = value;
  archive(number, error, snapshot, arrays);
}

}  // namespace gluray::cluster
