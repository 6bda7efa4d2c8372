#include "accel/cache/build_plan.h"

#include <algorithm>

namespace gluray::accel {
namespace {

// Peak bytes per triangle of a build, measured on isosurfaces of 1 to 64 million triangles. kBlockBytes: with
// blocks alone as leaves; bundles of blocks need less.
constexpr size_t kFastBytes = 100, kBlockBytes = 56, kFullBytes = 110, kCompactBytes = 42;
// Memory left for the rest of the process and the machine.
constexpr size_t kReserve = size_t{256} << 20;
// Two threads build this many triangles in 20 ms as full, in 5 ms as fast; below, nobody sees a difference.
constexpr uint64_t kMuch = 100'000;
// Meshes below this are built full at once: rebuilding the TLAS for each refinement would cost more.
constexpr uint64_t kSmall = 20'000;

}  // namespace

BvhQuality firstQuality(BvhQuality wanted, uint64_t triangles, const Waiting& waiting,
                        FreeMemory freeMemory) {
  if (wanted != BvhQuality::automatic) return wanted;
  if (waiting.triangles < kMuch || triangles < kSmall) return BvhQuality::full;
  const size_t free = freeMemory(), room = (free - std::min(free, kReserve)) / 2;
  const uint64_t fast = waiting.inBlocks * kBlockBytes + (waiting.triangles - waiting.inBlocks) * kFastBytes;
  // With triangle blocks as leaves, fast structures need about half the memory of those with triangles, or
  // less. Full structures are built one at a time, each beside all the fast ones.
  const bool blocks = waiting.inBlocks >= waiting.triangles / 8 * 7;
  if (room >= (blocks ? fast : fast + triangles * kFullBytes)) return BvhQuality::fast;
  if (room >= waiting.triangles * kFullBytes) return BvhQuality::full;
  return room >= waiting.triangles * kCompactBytes ? BvhQuality::compact : BvhQuality::least;
}

BvhQuality thriftyQuality(BvhQuality wanted, uint64_t triangles) {
  if (triangles >= kSmall) return BvhQuality::least;
  return wanted == BvhQuality::automatic ? BvhQuality::full : wanted;
}

bool worthRefining(BvhQuality wanted, BvhQuality held, uint64_t frames) {
  constexpr uint64_t kSettled = 4;  // excludes geometry that changes in every frame
  return wanted == BvhQuality::automatic && held == BvhQuality::fast && frames >= kSettled;
}

bool roomToRefine(uint64_t triangles, FreeMemory freeMemory) {
  return freeMemory() / 5 * 2 >= triangles * kFullBytes;
}

}  // namespace gluray::accel
