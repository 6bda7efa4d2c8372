#include "gl/arrays/primitive_restart.h"

#include "base/hash.h"
#include "gl/arrays/arrays.h"
#include "gl/buffers/buffer.h"
#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>

namespace gluray::gl {
namespace {

constexpr size_t kMostKnown = 4096;

uint32_t largestOf(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 0xFF : type == GL_UNSIGNED_SHORT ? 0xFFFF : ~0u;
}

/// Whether any of `count` indices, which may be unaligned, is `wanted`.
template <class Index>
bool contains(const std::byte* from, size_t count, uint32_t wanted) {
  for (size_t i = 0; i < count;) {
    constexpr size_t kBlock = 1024;  // without a branch for each index
    Index block[kBlock];
    const size_t size = std::min(kBlock, count - i);
    std::memcpy(block, from + i * sizeof(Index), size * sizeof(Index));
    bool found = false;
    for (size_t k = 0; k < size; ++k) found |= block[k] == static_cast<Index>(wanted);
    if (found) return true;
    i += size;
  }
  return false;
}

bool contains(const std::byte* from, size_t count, GLenum type, uint32_t wanted) {
  if (type == GL_UNSIGNED_BYTE) return contains<uint8_t>(from, count, wanted);
  if (type == GL_UNSIGNED_SHORT) return contains<uint16_t>(from, count, wanted);
  return contains<uint32_t>(from, count, wanted);
}

}  // namespace

std::optional<uint32_t> PrimitiveRestart::indexOf(GLenum type) const {
  if (!type) return {};
  const uint32_t largest = largestOf(type);
  if (atLargest) return largest;
  return at && *at <= largest ? at : std::nullopt;
}

PrimitiveRestart readRestart(const RealGl& real) {
  const int version = versionOf(real);
  PrimitiveRestart restart;
  restart.atLargest = (version >= 43 || hasExtension(real, version, "GL_ARB_ES3_compatibility")) &&
                      isOn(real, GL_PRIMITIVE_RESTART_FIXED_INDEX);
  if (!isPresent(real.PrimitiveRestartIndex)) return restart;
  if (version < 31)
    restart.byExtension = isOn(real, GL_PRIMITIVE_RESTART_NV);
  else if (isOn(real, GL_PRIMITIVE_RESTART))
    restart.at = static_cast<uint32_t>(integer(real, GL_PRIMITIVE_RESTART_INDEX));
  return restart;
}

bool RestartedDraws::search(const RealGl& real, const PrimitiveRestart& restart, Buffer* buffer,
                            const Elements& e) {
  if (restart.byExtension) return true;
  const std::optional<uint32_t> wanted = restart.indexOf(e.type);
  if (!wanted || e.count <= 0) return false;
  const auto* from = static_cast<const std::byte*>(e.indices);
  auto count = static_cast<size_t>(e.count);
  if (!buffer) return from && contains(from, count, e.type, *wanted);
  const auto offset = reinterpret_cast<size_t>(e.indices);
  const uint64_t name[] = {buffer->serial(), buffer->version(), offset, count, e.type, *wanted};
  const uint64_t key = hashBytes(name, sizeof name).low;
  if (!buffer->foreign)
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const std::shared_ptr<const BufferStorage> storage = buffer->read(real);
  if (!storage || offset > storage->size) return false;
  count = std::min(count, (storage->size - offset) / sizeOfType(e.type));
  const bool found = contains(storage->data + offset, count, e.type, *wanted);
  if (known_.size() >= kMostKnown) known_.clear();
  return known_[key] = found;
}

}  // namespace gluray::gl
