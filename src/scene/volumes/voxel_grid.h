// The voxels of a volume, as they were uploaded. Immutable; a changed texture makes a new grid.
#pragma once
#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace gluray::scene {

/// A 3D texture image: x fastest, then y, then z; all voxels of a channel, then those of the next one.
struct VoxelGrid {
  enum class Type : uint8_t { byte, signedByte, word, signedWord, single };

  Type type = Type::single;
  glm::ivec3 size{0};
  int channels = 1;                     // 1 to 4
  bool grey = false;                    // one channel, which is red, green and blue of what a texture returns
  std::unique_ptr<std::byte[]> values;  // followed by kPadding bytes that may be read
  static constexpr size_t kPadding = 16;

  size_t voxels() const {
    return static_cast<size_t>(size.x) * static_cast<size_t>(size.y) * static_cast<size_t>(size.z);
  }
  size_t bytes() const;
  /// Where channel `channel` begins.
  const std::byte* channel(int channel) const;
};

/// Bytes of a channel.
constexpr size_t sizeOf(VoxelGrid::Type type) {
  switch (type) {
    case VoxelGrid::Type::byte:
    case VoxelGrid::Type::signedByte: return 1;
    case VoxelGrid::Type::single: return 4;
    default: return 2;
  }
}

inline size_t VoxelGrid::bytes() const { return voxels() * static_cast<size_t>(channels) * sizeOf(type); }
inline const std::byte* VoxelGrid::channel(int channel) const {
  return values.get() + voxels() * static_cast<size_t>(channel) * sizeOf(type);
}

/// By what a stored number is divided to give the value that a texture returns (OpenGL 4.6, 2.3.5); signed
/// ones are at least -1.
constexpr float divisorOf(VoxelGrid::Type type) {
  switch (type) {
    case VoxelGrid::Type::byte: return 255;
    case VoxelGrid::Type::signedByte: return 127;
    case VoxelGrid::Type::word: return 65535;
    case VoxelGrid::Type::signedWord: return 32767;
    default: return 1;
  }
}

}  // namespace gluray::scene
