// Arrays that scenes share across frames: attributes of meshes, and texels. They are identified by the hash
// of their content, so that each is sent once.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

/// A sender's array, whose elements need not be contiguous. `owner` keeps them alive.
struct ArraySource {
  Hash128 name;  // hash of the content as written by copyTo()
  std::shared_ptr<const void> owner;
  const std::byte* data = nullptr;
  uint32_t count = 0, stride = 0, element = 0;  // stride and element: bytes
  size_t bytes() const { return size_t{count} * element; }
  /// Copies the elements contiguously, bytes() bytes.
  void copyTo(std::byte* to) const;
};

/// The receiver's copy, and kArrayPadding readable bytes behind it.
struct Array {
  std::shared_ptr<const void> owner;  // null: unknown
  std::span<const std::byte> bytes;
};
constexpr size_t kArrayPadding = 16;  // as scene/mesh.h promises
Array makeArray(std::span<const std::byte> content);
/// A new array of so many bytes, which the caller fills.
struct ArrayRoom {
  std::shared_ptr<std::byte[]> memory;
  size_t bytes = 0;
  std::span<std::byte> content() const { return {memory.get(), bytes}; }
  Array array() const { return {memory, {memory.get(), bytes}}; }
};
ArrayRoom arrayRoom(size_t bytes);
/// Copies a source into a new array.
Array makeArray(const ArraySource& source);

/// Finds the array of a name. Any thread.
using FindArray = std::function<Array(const Hash128& name)>;

/// Bytes of an element.
constexpr uint32_t bytesOf(scene::Format format) {
  switch (format) {
    case scene::Format::none: return 0;
    case scene::Format::float2: return 8;
    case scene::Format::float3: return 12;
    case scene::Format::float4: return 16;
    case scene::Format::bits8: return 1;
    default: return 4;
  }
}

/// Names arrays by content, and caches the names while the arrays exist, so that each is hashed once. One
/// thread.
class ArrayNames {
 public:
  /// Of `count` elements from the first one on. `owner` must not be null, and the elements never change while
  /// it lives.
  ArraySource named(const std::shared_ptr<const void>& owner, const std::byte* data, uint32_t count,
                    uint32_t stride, uint32_t element);
  /// Removes expired arrays. Call occasionally.
  void forgetGone();
  size_t size() const { return known_.size(); }

 private:
  struct Key {
    const void* owner;
    const std::byte* data;
    uint32_t count, stride, element;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    size_t operator()(const Key& key) const noexcept;
  };
  struct Known {
    std::weak_ptr<const void> owner;
    Hash128 name;
  };
  std::unordered_map<Key, Known, KeyHash> known_;
};

}  // namespace gluray::cluster
