#include "saved/export/arrays/array_source.h"

#include "parallel/loops.h"

namespace gluray::saved {

void readAll(const ArraySource& source, size_t first, size_t count, std::byte* out) {
  constexpr size_t kGrain = size_t{1} << 15;
  const size_t each = bytesOf(source.element());
  forPieces(count, kGrain,
            [&](size_t from, size_t to) { source.read(first + from, to - from, out + from * each); });
}

}  // namespace gluray::saved
