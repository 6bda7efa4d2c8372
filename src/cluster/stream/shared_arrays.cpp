#include "cluster/stream/shared_arrays.h"

#include <cstring>
#include <iterator>
#include <utility>

namespace gluray::cluster {
namespace {

/// Of the content, without copying elements that lie side by side.
Hash128 contentHash(const ArraySource& source) {
  if (source.stride == source.element) return hashBytes(source.data, source.bytes());
  std::vector<std::byte> copy(source.bytes());
  source.copyTo(copy.data());
  return hashBytes(copy.data(), copy.size());
}

}  // namespace

void ArraySource::copyTo(std::byte* to) const {
  if (stride == element) {
    if (count > 0) std::memcpy(to, data, bytes());
    return;
  }
  for (uint32_t i = 0; i < count; ++i, to += element)
    std::memcpy(to, data + static_cast<size_t>(i) * stride, element);
}

ArrayRoom arrayRoom(size_t bytes) {
  std::shared_ptr<std::byte[]> memory(new std::byte[bytes + kArrayPadding]);
  std::memset(memory.get() + bytes, 0, kArrayPadding);
  return {std::move(memory), bytes};
}

Array makeArray(std::span<const std::byte> content) {
  const ArrayRoom room = arrayRoom(content.size());
  if (!content.empty()) std::memcpy(room.memory.get(), content.data(), content.size());
  return room.array();
}

Array makeArray(const ArraySource& source) {
  const ArrayRoom room = arrayRoom(source.bytes());
  source.copyTo(room.memory.get());
  return room.array();
}

size_t ArrayNames::KeyHash::operator()(const Key& key) const noexcept {
  const auto mixed = reinterpret_cast<uintptr_t>(key.data) * 0x9E3779B97F4A7C15u;
  return mixed ^ (uint64_t{key.count} << 20) ^ (uint64_t{key.stride} << 8) ^ key.element;
}

ArraySource ArrayNames::named(const std::shared_ptr<const void>& owner, const std::byte* data, uint32_t count,
                              uint32_t stride, uint32_t element) {
  ArraySource source{{}, owner, data, count, stride, element};
  const auto [known, isNew] = known_.try_emplace({owner.get(), data, count, stride, element});
  // Another array may lie where one that is gone was.
  if (isNew || known->second.owner.expired()) {
    try {
      known->second = {owner, contentHash(source)};
    } catch (...) {
      known_.erase(known);
      throw;
    }
  }
  source.name = known->second.name;
  return source;
}

void ArrayNames::forgetGone() {
  std::erase_if(known_, [](const auto& entry) { return entry.second.owner.expired(); });
}

}  // namespace gluray::cluster
