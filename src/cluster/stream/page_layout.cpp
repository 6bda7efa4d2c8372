#include "cluster/stream/page_layout.h"

#include "cluster/stream/shared_arrays.h"

namespace gluray::cluster {
namespace {

constexpr size_t kAligned = 64;
static_assert(kArrayPadding <= kAligned);

/// Calls f(attribute, offset) for each array; returns the bytes of all.
template <class Mesh, class Arrays, class F>
size_t eachPlace(Mesh& mesh, Arrays& ofTriangles, const F& f) {
  size_t offset = 0;
  eachArray(mesh, ofTriangles, [&](auto& a, uint32_t count) {
    if (!a) return;
    f(a, offset);
    offset += (size_t{count} * bytesOf(a.format) + kArrayPadding + kAligned - 1) / kAligned * kAligned;
  });
  return offset;
}

}  // namespace

size_t pageBytes(const scene::Mesh& mesh, const TriangleArrays& ofTriangles) {
  return eachPlace(mesh, ofTriangles, [](const scene::Attribute&, size_t) {});
}

void layOut(scene::Mesh& mesh, TriangleArrays& ofTriangles, const std::shared_ptr<std::byte>& memory) {
  eachPlace(mesh, ofTriangles, [&](scene::Attribute& a, size_t offset) {
    a.owner = memory, a.data = memory.get() + offset, a.stride = bytesOf(a.format);
  });
}

}  // namespace gluray::cluster
