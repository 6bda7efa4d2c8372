#include "bench/data/nifti.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace gluray::bench {
namespace {

constexpr int kHeaderSize = 348;
constexpr int64_t kMaxPoints = int64_t(1) << 31;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw std::runtime_error(path + ": " + why);
}

/// The value of type T at byte `offset` of the header.
template <typename T>
T field(const std::vector<uint8_t>& header, size_t offset) {
  T out;
  std::memcpy(&out, header.data() + offset, sizeof out);
  return out;
}

/// Reads `count` values of type T from the stream and fills `out` with them as floats.
template <typename T>
bool readAs(gzFile file, size_t count, float* out) {
  std::vector<T> block(std::min<size_t>(count, 1 << 20));
  for (size_t done = 0; done < count;) {
    const size_t now = std::min(block.size(), count - done);
    const int bytes = int(now * sizeof(T));
    if (gzread(file, block.data(), unsigned(bytes)) != bytes) return false;
    std::copy_n(block.begin(), now, out + done);
    done += now;
  }
  return true;
}

/// Reads values of the NIfTI type code. False where the file ends early; throws for a code we do not know.
bool readValues(const std::string& path, gzFile file, int type, std::vector<float>& out) {
  switch (type) {
    case 2: return readAs<uint8_t>(file, out.size(), out.data());
    case 4: return readAs<int16_t>(file, out.size(), out.data());
    case 8: return readAs<int32_t>(file, out.size(), out.data());
    case 16: return readAs<float>(file, out.size(), out.data());
    case 64: return readAs<double>(file, out.size(), out.data());
    case 256: return readAs<int8_t>(file, out.size(), out.data());
    case 512: return readAs<uint16_t>(file, out.size(), out.data());
    case 768: return readAs<uint32_t>(file, out.size(), out.data());
    default:
      fail(path, "NIfTI data type " + std::to_string(type) + " is not one of the scalar types read here");
  }
}

}  // namespace

Volume readNifti(const std::string& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) fail(path, "cannot be opened");
  std::vector<uint8_t> header(kHeaderSize);
  if (gzread(file.get(), header.data(), kHeaderSize) != kHeaderSize)
    fail(path, "too short for a NIfTI header");
  if (field<int32_t>(header, 0) != kHeaderSize || std::memcmp(header.data() + 344, "n+1", 4) != 0)
    fail(path, "not a single-file little-endian NIfTI-1 volume");

  Volume out;
  int64_t points = 1;
  for (int axis = 0; axis < 3; ++axis) {
    out.size[axis] = field<int16_t>(header, 42 + 2 * size_t(axis));
    if (out.size[axis] < 2) fail(path, "needs at least two points along each axis");
    points *= out.size[axis];
    const float spacing = std::fabs(field<float>(header, 80 + 4 * size_t(axis)));
    out.spacing[axis] = spacing > 0 && std::isfinite(spacing) ? spacing : 1.0f;
  }
  if (points > kMaxPoints) fail(path, "has more than 2^31 points");
  const float offset = field<float>(header, 108);
  if (!(offset >= kHeaderSize && offset < 1e9f)) fail(path, "has an invalid data offset");
  if (gzseek(file.get(), z_off_t(offset), SEEK_SET) < 0) fail(path, "ends before its data");

  out.values.resize(size_t(points));
  if (!readValues(path, file.get(), field<int16_t>(header, 70), out.values))
    fail(path, "ends before its data does");
  const float slope = field<float>(header, 112), intercept = field<float>(header, 116);
  if (slope != 0 && std::isfinite(slope) && (slope != 1 || intercept != 0))
    for (float& value : out.values) value = value * slope + intercept;
  return out;
}

}  // namespace gluray::bench
