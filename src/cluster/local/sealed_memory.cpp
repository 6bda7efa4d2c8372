#include "cluster/local/sealed_memory.h"

#include "cluster/stream/byte_stream.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL;
// A process may have 65530 mappings (Linux's vm.max_map_count), and programs of many blocks have more arrays.
constexpr size_t kMaxCopiedBytes = size_t{1} << 16;  // bytes

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Unmapped when the last user lets go of it.
std::shared_ptr<std::byte> mapping(int descriptor, size_t size, int protection, int kind) {
  void* const address = mmap(nullptr, size, protection, kind, descriptor, 0);
  if (address == MAP_FAILED) fail("cannot map shared memory");
  return {static_cast<std::byte*>(address), [size](std::byte* at) { munmap(at, size); }};
}

/// Of `size` bytes, zero. Its pages are allocated now: a machine without memory would end the process at the
/// first write.
Descriptor newMemory(size_t size) {
  Descriptor memory(memfd_create("gluray", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (memory.get() < 0) fail("cannot make shared memory");
  if (const int error = posix_fallocate(memory.get(), 0, static_cast<off_t>(size)); error != 0)
    throw std::system_error(error, std::generic_category(), "cannot allocate shared memory");
  return memory;
}

void seal(const Descriptor& memory, int seals) {
  if (fcntl(memory.get(), F_ADD_SEALS, seals) != 0) fail("cannot seal shared memory");
}

/// Throws Malformed unless the memory has these seals and this size.
void checkSealed(const Descriptor& memory, int seals, size_t size) {
  const int found = fcntl(memory.get(), F_GET_SEALS);
  if (found < 0 || (found & seals) != seals) throw Malformed("shared memory is not sealed");
  struct stat status {};
  if (fstat(memory.get(), &status) != 0) fail("cannot read the size of shared memory");
  if (status.st_size < 0 || static_cast<size_t>(status.st_size) != size)
    throw Malformed("shared memory has another size");
}

}  // namespace

Descriptor sealedMemory(size_t bytes, const std::function<void(std::byte*)>& fill) {
  const size_t size = bytes + kArrayPadding;
  Descriptor memory = newMemory(size);
  fill(mapping(memory.get(), size, PROT_READ | PROT_WRITE, MAP_SHARED).get());
  seal(memory, kSeals);
  return memory;
}

Array mapSealed(const Descriptor& memory, size_t bytes) {
  const size_t size = bytes + kArrayPadding;
  checkSealed(memory, F_SEAL_SHRINK | F_SEAL_WRITE, size);
  const std::shared_ptr<std::byte> at = mapping(memory.get(), size, PROT_READ, MAP_SHARED);
  const std::span<const std::byte> content(at.get(), bytes);
  return bytes <= kMaxCopiedBytes ? makeArray(content) : Array{at, content};
}

WrittenMemory writtenMemory(size_t bytes) {
  Descriptor memory = newMemory(bytes);
  std::shared_ptr<std::byte> at = mapping(memory.get(), bytes, PROT_READ | PROT_WRITE, MAP_SHARED);
  seal(memory, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
  return {std::move(memory), std::move(at), bytes};
}

std::shared_ptr<const std::byte> mapWritten(const Descriptor& memory, size_t bytes) {
  checkSealed(memory, F_SEAL_SHRINK, bytes);
  return mapping(memory.get(), bytes, PROT_READ, MAP_SHARED);
}

}  // namespace gluray::cluster
