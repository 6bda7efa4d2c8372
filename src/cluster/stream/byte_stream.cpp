#include "cluster/stream/byte_stream.h"

#include <cstdint>

namespace gluray::cluster {

// Not inline: archives call them some thousand times.

void ByteWriter::put(const void* bytes, size_t size) {
  const auto* first = static_cast<const std::byte*>(bytes);
  bytes_.insert(bytes_.end(), first, first + size);
}

std::span<const std::byte> ByteReader::readBytes(size_t size) {
  if (size > bytes_.size()) throw Malformed("it ends too early");
  const auto taken = bytes_.first(size);
  bytes_ = bytes_.subspan(size);
  return taken;
}

size_t ByteReader::count(size_t least) {
  const auto count = get<uint64_t>();
  if (count > bytes_.size() / least) throw Malformed("a list is longer than the message");
  return static_cast<size_t>(count);
}

}  // namespace gluray::cluster
