// Memory that processes of one machine share and nobody can change any more: arrays go from the program to
// workers without another copy. Any thread.
#pragma once
#include "cluster/stream/shared_arrays.h"
#include "control/descriptor.h"

#include <cstddef>
#include <functional>

namespace gluray::cluster {

using control::Descriptor;

/// New memory of `bytes` bytes and kArrayPadding zeros, which `fill` writes; sealed afterwards. Throws
/// std::system_error where there is none.
Descriptor sealedMemory(size_t bytes, const std::function<void(std::byte*)>& fill);

/// Maps memory that another process has sealed, or copies it where it is small. Throws Malformed where it is
/// not sealed, because its sender could change it while it is read, or cut it off, or where it does not hold
/// `bytes` bytes; std::system_error.
Array mapSealed(const Descriptor& memory, size_t bytes);

/// Memory of `bytes` bytes that one process writes and another reads; its size is sealed.
struct WrittenMemory {
  Descriptor memory;
  std::shared_ptr<std::byte> at;
  size_t bytes = 0;
};
/// Throws std::system_error.
WrittenMemory writtenMemory(size_t bytes);
/// Maps another process's for reading. Throws Malformed where its size is another one, or not sealed: its
/// writer could cut it off; std::system_error.
std::shared_ptr<const std::byte> mapWritten(const Descriptor& memory, size_t bytes);

}  // namespace gluray::cluster
