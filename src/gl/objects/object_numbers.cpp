#include "gl/objects/object_numbers.h"

#include "scene/same_camera.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kMaxRemoved = 4096;
constexpr size_t kMaxComparedPlaces = size_t{1} << 16;  // places of surfaces of equal geometry

uint32_t nextObject() noexcept {
  static std::atomic<uint32_t> last{0};  // of all contexts
  return ++last;
}

Hash128 placeInEye(const scene::Instance& instance) {
  const glm::dmat4 matrix = instance.eyeFromObject + 0.0;  // -0 is 0
  return hashBytes(&matrix, sizeof matrix, instance.mesh->geometryId);
}

ObjectTraits traitsOf(const scene::Instance& instance) {
  const scene::Mesh& mesh = *instance.mesh;
  const scene::Material& material = instance.materials.front().front;
  const glm::vec4 colors[] = {material.ambient, material.diffuse, material.specular, instance.color};
  const auto formats = static_cast<uint64_t>(mesh.normals.format) |
                       static_cast<uint64_t>(mesh.colors.format) << 8 |
                       static_cast<uint64_t>(mesh.texcoords.format) << 16;
  return {mesh.geometryId, mesh.shape, mesh.triangleCount, hashBytes(colors, sizeof colors).low ^ formats};
}

bool areAtOnePlace(const glm::mat4& a, const glm::mat4& b) {
  constexpr float kRounding = 1e-4f;
  const float distance = std::max(glm::length(glm::vec3(a[3])), glm::length(glm::vec3(b[3])));
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(a[c][r] - b[c][r]) <= kRounding * (c == 3 ? std::max(distance, 1e-30f) : 1)))
        return false;
  return true;
}

}  // namespace

/// A batch while its surfaces are numbered.
struct ObjectNumbers::Batch {
  scene::Snapshot& snapshot;
  View& view;
  size_t viewIndex;
  std::vector<size_t> known;  // by instance: index in last_, or kNoObject
  std::vector<bool> again;    // an earlier instance is the same surface
  scene::Instance& at(size_t i) { return snapshot.instances[i]; }
  bool open(size_t i) { return at(i).object.value == 0 && !again[i]; }
};

void ObjectNumbers::beginFrame() {
  for (const Known& known : last_)
    if (!known.taken) {
      gone_.emplace(known.traits.geometry, known.number);
      goneSince_.push_back(known.traits.geometry);
    }
  for (; goneSince_.size() > kMaxRemoved; goneSince_.pop_front())
    if (const auto oldest = gone_.find(goneSince_.front()); oldest != gone_.end()) gone_.erase(oldest);
  last_ = std::exchange(now_, {});
  lastViews_ = std::exchange(views_, {});
  lastAt_.clear();
  for (size_t i = 0; i < last_.size(); ++i) lastAt_.emplace(last_[i].traits.geometry, i);
}

/// The view's index in this frame. Passes into framebuffers of their own belong to the view of equal size and
/// camera.
size_t ObjectNumbers::viewOf(const BatchKey& key, const scene::Snapshot& batch) {
  const double distance = glm::length(glm::dvec3(batch.eyeFromWorld[3]));
  for (size_t i = 0; i < views_.size(); ++i) {
    const View& view = views_[i];
    const glm::ivec4 &a = view.viewport, &b = key.viewport;
    const bool alike = view.framebuffer == key.framebuffer ? a == b : a.z == b.z && a.w == b.w;
    if (alike && scene::eyeFromEye(view.camera.clipFromEye, batch.camera.clipFromEye,
                                   std::max(distance, view.distance)))
      return i;
  }
  View& view = views_.emplace_back();
  view.framebuffer = key.framebuffer, view.viewport = key.viewport;
  view.camera = batch.camera, view.distance = distance;
  view.last = lastViewOf(view);
  return views_.size() - 1;
}

/// Framebuffers and windows may change names and sizes: then the drawing order decides.
size_t ObjectNumbers::lastViewOf(const View& view) const {
  const auto isFree = [&](size_t i) {
    return std::none_of(views_.begin(), views_.end() - 1, [&](const View& v) { return v.last == i; });
  };
  for (const bool named : {true, false})
    for (size_t i = 0; i < lastViews_.size(); ++i) {
      const View& last = lastViews_[i];
      const bool same = !named || last.framebuffer == view.framebuffer;
      if (same && last.viewport == view.viewport && isFree(i)) return i;
    }
  const size_t turn = views_.size() - 1;
  return turn < lastViews_.size() && isFree(turn) ? turn : kNoObject;
}

void ObjectNumbers::number(const BatchKey& key, scene::Snapshot& snapshot) {
  const size_t index = viewOf(key, snapshot);
  const size_t count = snapshot.instances.size();
  Batch batch{snapshot, views_[index], index, std::vector<size_t>(count, kNoObject),
              std::vector<bool>(count)};
  takeDrawnBefore(batch);
  takeByGeometry(batch);
  takeGone(batch);
  takeByOrder(batch);
  finish(batch);
  ++views_[index].batches;
}

void ObjectNumbers::takeDrawnBefore(Batch& batch) {
  std::unordered_set<Hash128> here;
  for (size_t i = 0; i < batch.known.size(); ++i) {
    const Hash128 place = placeInEye(batch.at(i));
    const auto found = batch.view.numbered.find(place);
    if (found != batch.view.numbered.end()) batch.at(i).object.value = found->second;
    batch.again[i] = !here.insert(place).second;
  }
}

void ObjectNumbers::takeNumber(Batch& batch, size_t instance, size_t known) {
  last_[known].taken = true;
  batch.at(instance).object.value = last_[known].number;
  batch.known[instance] = known;
}

void ObjectNumbers::takeByGeometry(Batch& batch) {
  std::unordered_map<Hash128, std::vector<size_t>> groups;
  for (size_t i = 0; i < batch.known.size(); ++i)
    if (batch.open(i)) groups[batch.at(i).mesh->geometryId].push_back(i);
  for (auto& [geometry, instances] : groups) {
    std::vector<size_t> candidates;
    const auto [first, last] = lastAt_.equal_range(geometry);
    for (auto it = first; it != last; ++it)
      if (!last_[it->second].taken && last_[it->second].view == batch.view.last)
        candidates.push_back(it->second);
    std::sort(candidates.begin(), candidates.end());
    takeByPlace(batch, instances, candidates);
    for (size_t i = 0; i < std::min(instances.size(), candidates.size()); ++i)
      takeNumber(batch, instances[i], candidates[i]);
  }
}

/// Pairs of an instance and a candidate at the same place.
std::vector<ObjectNumbers::Pair> ObjectNumbers::atOnePlace(Batch& batch, const std::vector<size_t>& instances,
                                                           std::vector<size_t> candidates,
                                                           glm::mat4 Known::*space) const {
  std::vector<Pair> pairs;
  for (const size_t instance : instances) {
    const scene::Instance& now = batch.at(instance);
    const glm::mat4 place = space == &Known::inEye ? glm::mat4(now.eyeFromObject) : now.worldFromObject;
    const auto near = std::find_if(candidates.begin(), candidates.end(),
                                   [&](size_t k) { return areAtOnePlace(last_[k].*space, place); });
    if (near == candidates.end()) continue;
    pairs.push_back({instance, *near});
    candidates.erase(near);
  }
  return pairs;
}

/// Matches surfaces of equal geometry that have not moved, and removes them from both lists. The camera may
/// have moved, or the batch may begin with another surface.
void ObjectNumbers::takeByPlace(Batch& batch, std::vector<size_t>& instances,
                                std::vector<size_t>& candidates) {
  if (candidates.empty() || instances.size() * candidates.size() > kMaxComparedPlaces) return;
  std::vector<Pair> pairs = atOnePlace(batch, instances, candidates, &Known::inEye);
  if (pairs.size() < std::min(instances.size(), candidates.size())) {
    std::vector<Pair> inWorld = atOnePlace(batch, instances, candidates, &Known::place);
    if (inWorld.size() > pairs.size()) pairs = std::move(inWorld);
  }
  for (const Pair& pair : pairs) {
    takeNumber(batch, pair.instance, pair.known);
    std::erase(instances, pair.instance), std::erase(candidates, pair.known);
  }
}

void ObjectNumbers::takeGone(Batch& batch) {
  for (size_t i = 0; i < batch.known.size() && !gone_.empty(); ++i) {
    if (!batch.open(i)) continue;
    const auto [first, last] = gone_.equal_range(batch.at(i).mesh->geometryId);
    const auto oldest =
        std::min_element(first, last, [](const auto& a, const auto& b) { return a.second < b.second; });
    if (oldest == last) continue;
    batch.at(i).object.value = oldest->second;
    gone_.erase(oldest);
  }
}

/// Matches the surfaces between matched ones.
void ObjectNumbers::takeByOrder(Batch& batch) {
  size_t begin = 0, first = batch.view.next;
  for (size_t i = 0; i <= batch.known.size(); ++i) {
    const bool end = i == batch.known.size();
    if (!end && batch.known[i] == kNoObject) continue;
    const size_t last = end ? last_.size() : batch.known[i];
    if (begin < i && first < last) alignGap(batch, begin, i, first, last);
    begin = i + 1;
    if (!end) first = std::max(first, last + 1);
  }
  for (const size_t known : batch.known)
    if (known != kNoObject) batch.view.next = std::max(batch.view.next, known + 1);
}

/// Instances [begin, end) lie between the matched surfaces first - 1 and last. Surfaces that the last frame
/// drew in other batches are not considered.
void ObjectNumbers::alignGap(Batch& batch, size_t begin, size_t end, size_t first, size_t last) {
  std::vector<size_t> before, now;
  for (size_t k = first; k < last; ++k)
    if (!last_[k].taken && last_[k].view == batch.view.last && last_[k].batch == batch.view.batches)
      before.push_back(k);
  for (size_t i = begin; i < end; ++i)
    if (batch.open(i)) now.push_back(i);
  if (before.empty() || now.empty()) return;
  std::vector<ObjectTraits> traits;
  traits.reserve(now.size());
  std::vector<const ObjectTraits*> left, right;
  for (const size_t k : before) left.push_back(&last_[k].traits);
  for (const size_t i : now) traits.push_back(traitsOf(batch.at(i))), right.push_back(&traits.back());
  const std::vector<size_t> found = alignObjects(left, right);
  for (size_t i = 0; i < found.size(); ++i)
    if (found[i] != kNoObject) takeNumber(batch, now[i], before[found[i]]);
}

/// Gives new objects new numbers, and remembers all surfaces for the next frame.
void ObjectNumbers::finish(Batch& batch) {
  for (scene::Instance& instance : batch.snapshot.instances) {
    const Hash128 place = placeInEye(instance);
    const auto found = batch.view.numbered.find(place);
    const bool known = found != batch.view.numbered.end();
    if (instance.object.value == 0) instance.object.value = known ? found->second : nextObject();
    if (known) continue;
    batch.view.numbered.emplace(place, instance.object.value);
    now_.push_back({traitsOf(instance), instance.object.value, batch.viewIndex, batch.view.batches,
                    instance.worldFromObject, glm::mat4(instance.eyeFromObject), false});
  }
}

}  // namespace gluray::gl
