#include "gl/basics/growing_array.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace gluray::gl {
namespace {
constexpr size_t kLarge = size_t{1} << 20;  // bytes: blocks of at least this size are mmapped
}

void freeBlock(void* memory, size_t bytes) noexcept {
  if (!memory) return;
  if (bytes < kLarge)
    std::free(memory);
  else
    munmap(memory, bytes);
}

void* resizeBlock(void* memory, size_t oldBytes, size_t newBytes) noexcept {
  if (newBytes == 0) {
    freeBlock(memory, oldBytes);
    return nullptr;
  }
  if (oldBytes < kLarge && newBytes < kLarge) return std::realloc(memory, newBytes);
  if (oldBytes >= kLarge && newBytes >= kLarge) {
    void* moved = mremap(memory, oldBytes, newBytes, MREMAP_MAYMOVE);
    return moved == MAP_FAILED ? nullptr : moved;
  }
  void* other = newBytes < kLarge
                    ? std::malloc(newBytes)
                    : mmap(nullptr, newBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (!other || other == MAP_FAILED) return nullptr;
  if (memory) std::memcpy(other, memory, std::min(oldBytes, newBytes));
  freeBlock(memory, oldBytes);
  return other;
}

void throwNoMemory() { throw std::bad_alloc(); }

}  // namespace gluray::gl
