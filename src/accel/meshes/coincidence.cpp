#include "accel/meshes/coincidence.h"

#include "base/timeline.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <span>
#include <unordered_set>

namespace gluray::accel {
namespace {

/// A fast hash of multiplications and shifts in which every input bit counts.
uint64_t hashOf(const glm::vec3& p) {
  const glm::vec3 position = p + 0.0f;  // -0 is 0
  const auto bits = [&](int c) { return uint64_t{std::bit_cast<uint32_t>(position[c])}; };
  uint64_t h = (bits(0) | bits(1) << 32) * 0x9E3779B97F4A7C15u;
  h = (h ^ h >> 32 ^ bits(2)) * 0xD6E8FEB86659FD93u;
  h = (h ^ h >> 32) * 0xC2B2AE3D27D4EB4Fu;
  return h ^ h >> 29;
}

/// Hash of a triangle, independent of the order of its corners; 0 if two of them are equal.
uint64_t keyOf(const scene::Mesh& mesh, uint32_t triangle) {
  uint64_t corner[3];
  for (uint32_t k = 0; k < 3; ++k) corner[k] = hashOf(mesh.position(mesh.corner(triangle, k)));
  if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) return 0;
  return (corner[0] + corner[1] + corner[2]) | 1;
}

/// Bloom filter: three bits of one word per key.
class BitFilter {
 public:
  explicit BitFilter(uint64_t count) : words_(std::bit_ceil(std::max<uint64_t>(count / 4, 1))) {}
  /// Prefetches the key's word.
  void prefetch(uint64_t key) const { __builtin_prefetch(&words_[indexOf(key)], 1); }
  /// Adds the key; true if it, or others that share its bits, were present.
  bool insert(uint64_t key) {
    uint64_t& word = words_[indexOf(key)];
    const uint64_t bits = bitsOf(key);
    const bool there = (word & bits) == bits;
    word |= bits;
    return there;
  }
  bool mayHold(uint64_t key) const {
    const uint64_t bits = bitsOf(key);
    return (words_[indexOf(key)] & bits) == bits;
  }

 private:
  size_t indexOf(uint64_t key) const { return key >> 20 & (words_.size() - 1); }
  static uint64_t bitsOf(uint64_t key) {
    return uint64_t{1} << (key >> 1 & 63) | uint64_t{1} << (key >> 7 & 63) | uint64_t{1} << (key >> 13 & 63);
  }
  std::vector<uint64_t> words_;  // 16 to 32 bits per key: false positives 1/70 to 1/500
};

/// Calls visit(keys) for batches of triangle keys until it returns true; returns whether it did.
template <class Visit>
bool anyBlock(const std::vector<const scene::Mesh*>& meshes, const std::atomic<bool>& cancelled,
              Visit&& visit) {
  constexpr uint32_t kBlock = 512;  // triangles: enough for prefetches to arrive
  uint64_t keys[kBlock];
  for (const scene::Mesh* mesh : meshes)
    for (uint32_t first = 0; first < mesh->triangleCount; first += kBlock) {
      if (cancelled) return false;
      size_t count = 0;
      const uint32_t end = std::min(first + kBlock, mesh->triangleCount);
      for (uint32_t t = first; t < end; ++t) {
        keys[count] = keyOf(*mesh, t);
        count += keys[count] != 0;
      }
      if (visit(std::span<const uint64_t>(keys, count))) return true;
    }
  return false;
}

uint64_t triangleCount(const std::vector<const scene::Mesh*>& meshes) {
  uint64_t count = 0;
  for (const scene::Mesh* mesh : meshes) count += mesh->triangleCount;
  return count;
}

/// Keys whose bits were set already: all duplicates, and a few false positives.
std::vector<uint64_t> suspectsOf(const std::vector<const scene::Mesh*>& meshes,
                                 const std::atomic<bool>& cancelled) {
  std::vector<uint64_t> suspects;
  BitFilter seen(triangleCount(meshes));
  anyBlock(meshes, cancelled, [&](std::span<const uint64_t> keys) {
    for (const uint64_t key : keys) seen.prefetch(key);
    for (const uint64_t key : keys)
      if (seen.insert(key)) suspects.push_back(key);
    return false;
  });
  return suspects;
}

}  // namespace

bool anyCoincide(const std::vector<const scene::Mesh*>& meshes, const std::atomic<bool>& cancelled) {
  const std::vector<uint64_t> suspects = suspectsOf(meshes, cancelled);
  if (suspects.empty()) return false;
  // A second pass finds the true duplicates.
  BitFilter suspected(suspects.size());
  for (const uint64_t key : suspects) suspected.insert(key);
  const std::unordered_set<uint64_t> exactly(suspects.begin(), suspects.end());
  std::unordered_set<uint64_t> once;
  return anyBlock(meshes, cancelled, [&](std::span<const uint64_t> keys) {
    return std::any_of(keys.begin(), keys.end(), [&](uint64_t key) {
      return suspected.mayHold(key) && exactly.contains(key) && !once.insert(key).second;
    });
  });
}

std::vector<Coincidence::Group> Coincidence::groupsOf(const std::vector<scene::Instance>& instances) {
  std::vector<Group> groups;
  std::unordered_map<Hash128, size_t> groupAt;
  std::unordered_set<Hash128> placed;
  for (const scene::Instance& instance : instances) {
    if (instance.mesh->triangleCount == 0 || instance.mesh->shape != scene::Shape::triangles) continue;
    const glm::mat4 place = instance.worldFromObject + 0.0f;  // -0 is 0
    const Hash128 placeId = hashBytes(glm::value_ptr(place), sizeof place);
    const auto [at, fresh] = groupAt.try_emplace(placeId, groups.size());
    if (fresh) groups.emplace_back();
    Group& group = groups[at->second];
    const Hash128& geometry = instance.mesh->geometryId;
    const Hash128 geometryHere = hashBytes(&geometry, sizeof geometry, placeId);
    if (!placed.insert(geometryHere).second) group.repeated = true;
    group.meshes.push_back(instance.mesh.get());
    group.triangles += instance.mesh->triangleCount;
    const Hash128 term = hashBytes(&geometry, sizeof geometry);
    group.id.low += term.low, group.id.high += term.high;
  }
  return groups;
}

bool Coincidence::possible(const std::vector<scene::Instance>& instances) {
  collect();
  bool possible = false;
  for (const Group& group : groupsOf(instances)) possible |= group.repeated || !known(group);
  return possible;
}

/// Whether the group is known to have no coincident triangles. Tests an unknown group now or in the
/// background.
bool Coincidence::known(const Group& group) {
  constexpr uint64_t kAtOnce = 10000;  // triangles, half a millisecond
  constexpr size_t kRemembered = 4096;
  if (answers_.size() > kRemembered) answers_.clear();
  const auto [answer, fresh] = answers_.try_emplace(group.id, Answer::asked);
  if (answer->second != Answer::asked) return answer->second == Answer::no;
  if (group.triangles <= kAtOnce) {
    answer->second = anyCoincide(group.meshes, false) ? Answer::yes : Answer::no;
    return answer->second == Answer::no;
  }
  // A group that is drawn only once is not worth a thread.
  if (!fresh && !job_.busy()) lookBehind(group);
  return false;
}

void Coincidence::lookBehind(const Group& group) {
  std::vector<scene::Mesh> meshes;  // copies share the arrays and keep them alive
  for (const scene::Mesh* mesh : group.meshes) meshes.push_back(*mesh);
  const auto found = std::make_shared<std::atomic<bool>>(false);
  const auto look = [meshes = std::move(meshes), found](const std::atomic<bool>& cancelled) {
    std::vector<const scene::Mesh*> all;
    for (const scene::Mesh& mesh : meshes) all.push_back(&mesh);
    timeline::nameThread("comparing");
    const timeline::Span span("compare triangles");
    *found = anyCoincide(all, cancelled);
  };
  // Not at low priority: the job is short, and rays are slower until it ends.
  if (!job_.start(look, BackgroundJob::Priority::usual)) return;
  looking_ = group.id;
  found_ = found;
}

void Coincidence::collect() {
  if (job_.poll() == BackgroundJob::Outcome::done) answers_[looking_] = *found_ ? Answer::yes : Answer::no;
}

}  // namespace gluray::accel
