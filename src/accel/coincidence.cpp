#include "accel/coincidence.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <unordered_set>

namespace gluray::accel {
namespace {

uint64_t hashOf(const glm::vec3& p) {
  const glm::vec3 position = p + 0.0f;  // -0 is 0
  return hashBytes(glm::value_ptr(position), sizeof position).low;
}

/// The same for every order of the corners; 0 where two of them are equal.
uint64_t keyOf(const scene::Mesh& mesh, uint32_t triangle) {
  uint64_t corner[3];
  for (uint32_t k = 0; k < 3; ++k) corner[k] = hashOf(mesh.position(mesh.corner(triangle, k)));
  if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) return 0;
  return (corner[0] + corner[1] + corner[2]) | 1;
}

/// A set that may hold too much: bits set by a hash.
class BitFilter {
 public:
  explicit BitFilter(uint64_t count) : words_(std::bit_ceil(std::max<uint64_t>(count / 4, 1))) {}
  /// Adds the key; whether it, or one that shares its bit, was there.
  bool insert(uint64_t key) {
    uint64_t& word = wordOf(key);
    const uint64_t bit = bitOf(key);
    const bool there = word & bit;
    word |= bit;
    return there;
  }
  bool mayHold(uint64_t key) { return wordOf(key) & bitOf(key); }

 private:
  uint64_t& wordOf(uint64_t key) { return words_[key >> 8 & (words_.size() - 1)]; }
  static uint64_t bitOf(uint64_t key) { return uint64_t{1} << (key >> 1 & 63); }
  std::vector<uint64_t> words_;  // 16 to 32 bits a key: one in 16 to 32 shares its bit
};

/// Calls visit(key) for each triangle with area until it returns true; whether it did.
template <class Visit>
bool anyTriangle(const std::vector<const scene::Mesh*>& meshes, const std::atomic<bool>& cancelled,
                 Visit&& visit) {
  constexpr uint32_t kAskedEvery = 1 << 16;  // triangles
  for (const scene::Mesh* mesh : meshes)
    for (uint32_t t = 0; t < mesh->triangleCount; ++t) {
      if (t % kAskedEvery == 0 && cancelled) return false;
      const uint64_t key = keyOf(*mesh, t);
      if (key && visit(key)) return true;
    }
  return false;
}

uint64_t triangleCount(const std::vector<const scene::Mesh*>& meshes) {
  uint64_t count = 0;
  for (const scene::Mesh* mesh : meshes) count += mesh->triangleCount;
  return count;
}

}  // namespace

bool anyCoincide(const std::vector<const scene::Mesh*>& meshes, const std::atomic<bool>& cancelled) {
  // Keys whose bit is taken are suspects; a second look tells which of them come twice.
  std::unordered_set<uint64_t> suspects;
  BitFilter seen(triangleCount(meshes));
  anyTriangle(meshes, cancelled, [&](uint64_t key) {
    if (seen.insert(key)) suspects.insert(key);
    return false;
  });
  if (suspects.empty()) return false;
  BitFilter suspected(suspects.size());
  for (const uint64_t key : suspects) suspected.insert(key);
  std::unordered_set<uint64_t> once;
  return anyTriangle(meshes, cancelled, [&](uint64_t key) {
    return suspected.mayHold(key) && suspects.contains(key) && !once.insert(key).second;
  });
}

std::vector<Coincidence::Group> Coincidence::groupsOf(const std::vector<scene::Instance>& instances) {
  std::vector<Group> groups;
  std::unordered_map<Hash128, size_t> groupAt;
  std::unordered_set<Hash128> placed;
  for (const scene::Instance& instance : instances) {
    if (instance.mesh->triangleCount == 0) continue;
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

/// Whether the group is known to have no triangles that coincide. Looks, now or behind, where nobody has.
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
  // What is drawn but once is not worth a thread.
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
    *found = anyCoincide(all, cancelled);
  };
  // Short, and until it has ended every ray is slower: not at low priority.
  if (!job_.start(look, BackgroundJob::Priority::usual)) return;
  looking_ = group.id;
  found_ = found;
}

void Coincidence::collect() {
  if (job_.poll() == BackgroundJob::Outcome::done) answers_[looking_] = *found_ ? Answer::yes : Answer::no;
}

}  // namespace gluray::accel
