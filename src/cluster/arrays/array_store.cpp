#include "cluster/arrays/array_store.h"

#include <algorithm>
#include <utility>

namespace gluray::cluster {

bool ArrayStore::change(Kept& kept, int head, int by) {
  if ((kept.uses[head] += by) == 0) kept.uses.erase(head);
  return std::ranges::none_of(kept.uses, [](const auto& use) { return use.second > 0; });
}

void ArrayStore::put(int head, const Hash128& name, Array array) {
  {
    const std::lock_guard lock(mutex_);
    Kept& kept = arrays_[name];
    const bool unused = change(kept, head, 1);
    if (!unused && !kept.array.owner) kept.array = std::move(array);
    if (kept.uses.empty()) arrays_.erase(name);
  }
  more_.notify_all();
}

void ArrayStore::forget(int head, const std::vector<Hash128>& names) {
  std::vector<Array> gone;  // freed when the lock is gone
  const std::lock_guard lock(mutex_);
  for (const Hash128& name : names) {
    Kept& kept = arrays_[name];
    if (!change(kept, head, -1)) continue;
    remember(name, kept.array);
    gone.push_back(std::exchange(kept.array, {}));
    if (kept.uses.empty()) arrays_.erase(name);
  }
}

void ArrayStore::remember(const Hash128& name, const Array& array) {
  if (array.owner.use_count() < 2) return;  // nobody else has it
  if (forgotten_.size() >= forgottenAtMost_) {
    std::erase_if(forgotten_, [](const auto& one) { return one.second.owner.expired(); });
    forgottenAtMost_ = 2 * forgotten_.size() + 64;
  }
  forgotten_[name] = {array.owner, array.bytes};
}

Array ArrayStore::find(const Hash128& name) const {
  const std::lock_guard lock(mutex_);
  return findLocked(name);
}

Array ArrayStore::findLocked(const Hash128& name) const {
  const auto found = arrays_.find(name);
  if (found != arrays_.end() && found->second.array.owner) return found->second.array;
  const auto before = forgotten_.find(name);
  if (before == forgotten_.end()) return {};
  Array array{before->second.owner.lock(), before->second.bytes};
  return array.owner ? array : Array{};
}

bool ArrayStore::waitFor(const std::vector<Hash128>& names, const std::function<bool()>& stop) {
  std::unique_lock lock(mutex_);
  const auto all = [&] {
    return std::ranges::all_of(names, [&](const Hash128& name) { return findLocked(name).owner != nullptr; });
  };
  more_.wait(lock, [&] { return stop() || all(); });
  return all();
}

void ArrayStore::wake() {
  { const std::lock_guard lock(mutex_); }  // whoever waits has looked at `stop` before, or looks after this
  more_.notify_all();
}

size_t ArrayStore::bytes() const {
  const std::lock_guard lock(mutex_);
  size_t sum = 0;
  for (const auto& [name, kept] : arrays_) sum += kept.array.bytes.size();
  return sum;
}

}  // namespace gluray::cluster
