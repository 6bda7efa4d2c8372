// Messages with properties of the ranks of a job of workers, and of their hosts. Any thread.
#pragma once
#include "cluster/messages/codec.h"

namespace gluray::cluster {

/// A rank's process and its host. Unknown texts are empty and unknown sizes 0.
struct RankFacts {
  int32_t rank = 0;
  bool answered = false;  // in time; otherwise only `rank` is known
  std::string version;    // of GLuRay; if it differs from the head's, all members below are unknown
  std::string mpi;        // Ranks::implementation()
  std::string host;
  int32_t rankHere = 0, ranksHere = 1;     // among the job's ranks on the host
  int32_t threads = 0;                     // that trace
  int32_t usableCores = 0, hostCores = 0;  // affinity of the process; all of the host
  std::string cores;                       // that the process may use: "0-3,8"
  uint64_t memoryBytes = 0, availableBytes = 0;
  uint64_t shmBytes = 0, shmFreeBytes = 0;  // of /dev/shm
  std::string hugePages;                    // transparent ones: "always", "madvise" or "never"
  bool isBigEndian = false;
};

/// From a head to all ranks.
struct FactsWanted {
  static constexpr uint16_t kType = 40;
  uint64_t id = 0;  // of the head's questions
};
/// To that head. Ranks of other versions understand this much.
struct FactsGiven {
  static constexpr uint16_t kType = 41;
  uint64_t id = 0;
  std::string version;           // of GLuRay
  std::vector<std::byte> facts;  // RankFacts, which may differ between versions
};

void fields(auto& archive, Like<RankFacts> auto& value) {
  auto& [rank, answered, version, mpi, host, rankHere, ranksHere, threads, usableCores, hostCores, cores,
         memoryBytes, availableBytes, shmBytes, shmFreeBytes, hugePages, isBigEndian] = value;
  archive(rank, answered, version, mpi, host, rankHere, ranksHere, threads, usableCores, hostCores, cores,
          memoryBytes, availableBytes, shmBytes, shmFreeBytes, hugePages, isBigEndian);
}
void fields(auto& archive, Like<FactsWanted> auto& value) {
  auto& [id] = value;
  archive(id);
}
void fields(auto& archive, Like<FactsGiven> auto& value) {
  auto& [id, version, facts] = value;
  archive(id, version, facts);
}

}  // namespace gluray::cluster
