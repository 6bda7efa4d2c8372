#include "bench/data/mesh_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace gluray::bench {
namespace {

struct Header {
  std::array<char, 16> magic{};
  uint64_t vertices = 0, indices = 0;
};
constexpr std::array<char, 16> kMagic{'G', 'L', 'u', 'R', 'a', 'y', ' ', 'm', 'e', 's', 'h', ' ', '1', '\n'};

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw std::runtime_error(path + ": " + why);
}

template <typename T>
bool put(FILE* file, const LargeArray<T>& array) {
  return std::fwrite(array.data(), sizeof(T), array.size(), file) == array.size();
}
template <typename T>
bool get(FILE* file, LargeArray<T>& array, size_t count, size_t room) {
  array.reserve(count + room);
  array.resize(count);
  return std::fread(array.data(), sizeof(T), count, file) == count;
}

}  // namespace

void writeMesh(const TriangleMesh& mesh, const std::string& path) {
  const std::string draft = path + ".part";
  File file(std::fopen(draft.c_str(), "wb"), std::fclose);
  if (!file) fail(draft, std::string("cannot be written: ") + std::strerror(errno));
  const Header header{kMagic, mesh.positions.size(), mesh.indices.size()};
  const bool written = std::fwrite(&header, sizeof header, 1, file.get()) == 1 &&
                       put(file.get(), mesh.positions) && put(file.get(), mesh.normals) &&
                       put(file.get(), mesh.indices);
  const bool closed = std::fclose(file.release()) == 0;
  if (!written || !closed || std::rename(draft.c_str(), path.c_str()) != 0) {
    std::remove(draft.c_str());
    fail(path, std::string("writing failed: ") + std::strerror(errno));
  }
}

TriangleMesh readMesh(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  Header header;
  if (std::fread(&header, sizeof header, 1, file.get()) != 1 || header.magic != kMagic)
    fail(path, "is not a mesh file of the benchmarks");
  struct stat status {};
  constexpr uint64_t kMax = uint64_t{1} << 40;  // beyond that the sum below could overflow
  if (fstat(fileno(file.get()), &status) != 0 || header.vertices > kMax || header.indices > kMax ||
      uint64_t(status.st_size) != sizeof header + 24 * header.vertices + 4 * header.indices)
    fail(path, "has the wrong length for its header");
  TriangleMesh mesh;
  if (!get(file.get(), mesh.positions, header.vertices, 2) ||
      !get(file.get(), mesh.normals, header.vertices, 0) || !get(file.get(), mesh.indices, header.indices, 0))
    fail(path, "could not be read to its end");
  if (std::any_of(mesh.indices.begin(), mesh.indices.end(), [&](uint32_t i) { return i >= header.vertices; }))
    fail(path, "has an index beyond its vertices");
  return mesh;
}

}  // namespace gluray::bench
