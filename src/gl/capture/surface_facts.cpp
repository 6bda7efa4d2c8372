#include "gl/capture/surface_facts.h"

#include <algorithm>
#include <cstring>

namespace gluray::gl {
namespace {

using Four = float __attribute__((vector_size(16)));  // x, y, z, 0
using FourBits = int32_t __attribute__((vector_size(16)));

constexpr uint32_t kChunk = 64;  // corners packed at a time

Bounds boundsOneByOne(const float* p, uint32_t count, uint32_t stride) {
  Bounds bounds;
  for (uint32_t i = 0; i < count; ++i, p += stride) {
    const glm::vec3 v(p[0], p[1], p[2]);
    if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) bounds.join({v, v});
  }
  return bounds;
}

FourBits bitsOf(const float* p) {
  FourBits bits;
  std::memcpy(&bits, p, sizeof bits);
  return bits & FourBits{-1, -1, -1, 0};
}

/// Compares bits, as comparing NaNs raises floating-point exceptions, which the program may have unmasked.
bool allFinite(const float* p, uint32_t count, uint32_t stride) {
  FourBits others{};
  for (uint32_t i = 0; i < count; ++i, p += stride) others |= (bitsOf(p) & 0x7FFFFFFF) >= 0x7F800000;
  return !(others[0] | others[1] | others[2]);
}

}  // namespace

Bounds boundsOfFinite(const float* positions, uint32_t count, uint32_t stride) {
  Four lower = Four{} + INFINITY, upper = Four{} - INFINITY;
  Bounds all;
  for (uint32_t first = 0; first < count; first += kChunk) {
    const uint32_t n = std::min(kChunk, count - first);
    const float* p = positions + size_t{first} * stride;
    if (!allFinite(p, n, stride)) {
      all.join(boundsOneByOne(p, n, stride));
      continue;
    }
    for (uint32_t i = 0; i < n; ++i, p += stride) {
      const auto v = reinterpret_cast<Four>(bitsOf(p));
      lower = v < lower ? v : lower, upper = v > upper ? v : upper;
    }
  }
  all.join({{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}});
  return all;
}

Hash128 identityOf(const std::vector<Hash128>& pieces, uint32_t triangles) {
  return hashBytes(pieces.data(), pieces.size() * sizeof(Hash128), {triangles, 0});
}

void SurfaceWatch::start() {
  spoiled_ = false;
  if (corners_ > 0) (void)piece_.finishHash();
  corners_ = 0;
  pieces_.clear();
  bounds_ = {};
}

void SurfaceWatch::add(const float* positions, uint32_t count, uint32_t stride) noexcept {
  if (spoiled_) return;
  try {
    while (count > 0) {
      const uint32_t n = std::min(count, kIdentityPiece - corners_ % kIdentityPiece);
      addToPiece(positions, n, stride);
      corners_ += n, count -= n, positions += size_t{n} * stride;
      if (corners_ % kIdentityPiece == 0) pieces_.push_back(piece_.finishHash());
    }
  } catch (...) { spoil(); }
}

void SurfaceWatch::addToPiece(const float* positions, uint32_t count, uint32_t stride) {
  float packed[3 * kChunk + 1];  // each copy writes one float more
  for (uint32_t first = 0; first < count; first += kChunk) {
    const uint32_t n = std::min(kChunk, count - first);
    const float* p = positions + size_t{first} * stride;
    for (uint32_t i = 0; i < n; ++i, p += stride) std::memcpy(packed + size_t{3} * i, p, 16);
    piece_.add(packed, size_t{n} * 12);
    bounds_.join(boundsOfFinite(packed, n, 3));
  }
}

bool SurfaceWatch::facts(SurfaceFacts& result) {
  if (spoiled_ || corners_ % 3 != 0) return false;
  std::vector<Hash128> pieces = pieces_;
  if (corners_ % kIdentityPiece != 0) pieces.push_back(piece_.finishHash());
  result = {identityOf(pieces, corners_ / 3), bounds_, corners_};
  spoil();  // the last piece's hash is finished
  return true;
}

}  // namespace gluray::gl
