// Immutable shared memory: arrays pass from the program to workers on the same machine without a copy. Any
// thread.
#pragma once
#include "cluster/stream/shared_arrays.h"
#include "control/descriptor.h"

#include <cstddef>
#include <functional>

namespace gluray::cluster {

using control::Descriptor;

/// Allocates `bytes` bytes and kArrayPadding zeros, lets `fill` write the bytes, and seals the memory. Throws
/// std::system_error on failure.
Descriptor sealedMemory(size_t bytes, const std::function<void(std::byte*)>& fill);

/// Maps memory that another process has sealed, or copies it if it is small. Throws Malformed if it does not
/// have `bytes` bytes, or is not sealed, because the sender could then change or truncate it;
/// std::system_error.
Array mapSealed(const Descriptor& memory, size_t bytes);

/// Memory of `bytes` bytes that one process writes and another reads; its size is sealed.
struct WrittenMemory {
  Descriptor memory;
  std::shared_ptr<std::byte> at;
  size_t bytes = 0;
};
/// Throws std::system_error.
WrittenMemory writtenMemory(size_t bytes);
/// Maps the memory of another process for reading. Throws Malformed if its size differs or is not sealed,
/// because the writer could truncate it; std::system_error.
std::shared_ptr<const std::byte> mapWritten(const Descriptor& memory, size_t bytes);

}  // namespace gluray::cluster
