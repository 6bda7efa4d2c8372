// Files of the benchmarks: NIfTI volumes in, PLY meshes, images and reports out.
#include "bench/data/nifti.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/data/triangle_mesh.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gluray::bench {
namespace {

/// Other users may run the tests, too.
std::string scratch(const std::string& name) {
  return testing::TempDir() + "gluray_bench_" + std::to_string(getpid()) + "_" + name;
}

template <typename T>
void put(std::string& bytes, size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

/// A 3 x 2 x 2 NIfTI-1 volume of 16-bit integers 0, 1, 2, ... with spacing (0.5, 1, 2), slope 2 and intercept
/// -1.
std::string smallNifti() {
  std::string bytes(352, '\0');
  put<int32_t>(bytes, 0, 348);
  const int16_t dims[] = {3, 3, 2, 2, 1};
  std::memcpy(bytes.data() + 40, dims, sizeof dims);
  put<int16_t>(bytes, 70, 4);
  const float pixdim[] = {1, 0.5f, 1, 2};
  std::memcpy(bytes.data() + 76, pixdim, sizeof pixdim);
  put<float>(bytes, 108, 352);
  put<float>(bytes, 112, 2);
  put<float>(bytes, 116, -1);
  std::memcpy(bytes.data() + 344, "n+1", 4);
  for (int16_t i = 0; i < 12; ++i) bytes.append(reinterpret_cast<const char*>(&i), sizeof i);
  return bytes;
}

std::string writeGzip(const std::string& name, const std::string& bytes) {
  const std::string path = scratch(name);
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, bytes.data(), unsigned(bytes.size()));
  gzclose(file);
  return path;
}

std::string errorOf(const std::string& path) {
  try {
    readNifti(path);
  } catch (const std::runtime_error& error) { return error.what(); }
  return "no error";
}

TEST(Nifti, ReadsCompressedIntegersWithScale) {
  const Volume volume = readNifti(writeGzip("small.nii.gz", smallNifti()));
  EXPECT_EQ(volume.size, (std::array<int, 3>{3, 2, 2}));
  EXPECT_EQ(volume.spacing, (std::array<float, 3>{0.5f, 1, 2}));
  ASSERT_EQ(volume.values.size(), 12u);
  EXPECT_FLOAT_EQ(volume.at(0, 0, 0), -1);
  EXPECT_FLOAT_EQ(volume.at(2, 1, 1), 21);
}

TEST(Nifti, ReportsErrors) {
  const std::string good = smallNifti();
  EXPECT_NE(errorOf("/nonexistent/head.nii").find("cannot be opened"), std::string::npos);
  EXPECT_NE(errorOf(writeGzip("short.nii.gz", good.substr(0, 100))).find("too short"), std::string::npos);
  EXPECT_NE(errorOf(writeGzip("cut.nii.gz", good.substr(0, 370))).find("ends before"), std::string::npos);
  std::string bad = good;
  bad[344] = 'x';
  EXPECT_NE(errorOf(writeGzip("magic.nii.gz", bad)).find("not a single-file"), std::string::npos);
  bad = good;
  put<int16_t>(bad, 42, -5);
  EXPECT_NE(errorOf(writeGzip("size.nii.gz", bad)).find("two points"), std::string::npos);
  bad = good;
  put<int16_t>(bad, 70, 128);
  EXPECT_NE(errorOf(writeGzip("type.nii.gz", bad)).find("data type 128"), std::string::npos);
}

TEST(Ply, WritesHeaderVerticesAndFaces) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.indices = {0, 1, 2};
  const std::string path = scratch("mesh.ply");
  writePly(mesh, path);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const size_t body = bytes.find("end_header\n") + 11;
  EXPECT_NE(bytes.find("element vertex 3\n"), std::string::npos);
  EXPECT_NE(bytes.find("element face 1\n"), std::string::npos);
  ASSERT_EQ(bytes.size() - body, 3 * 24u + 13u);
  float x;
  std::memcpy(&x, bytes.data() + body + 24, sizeof x);
  EXPECT_EQ(x, 1);
  EXPECT_EQ(bytes[body + 72], 3);
}

TEST(Ply, ReportsUnwritableFiles) {
  EXPECT_THROW(writePly(TriangleMesh{}, "/nonexistent/folder/mesh.ply"), std::runtime_error);
}

TEST(Png, ImagesRoundTrip) {
  // Two rows of two pixels, bottom row first: red, green; blue, white.
  const RgbImage image = imageFromGl(2, 2, {255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 255, 9, 255, 255, 255, 9});
  const std::vector<uint8_t> topDown{0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255, 0};
  EXPECT_EQ(image.rgb, topDown);
  const std::string path = scratch("image.png");
  writePng(image, path);
  EXPECT_EQ(readPng(path).rgb, topDown);
  EXPECT_THROW(readPng("/nonexistent.png"), std::runtime_error);
}

TEST(Png, SideBySideAlignsTops) {
  const RgbImage wide{2, 1, {1, 1, 1, 2, 2, 2}}, tall{1, 2, {3, 3, 3, 4, 4, 4}};
  const RgbImage both = sideBySide({wide, tall}, 1);
  EXPECT_EQ(both.width, 4);
  EXPECT_EQ(both.height, 2);
  const std::vector<uint8_t> expected{1,   1,   1,   2,   2,   2,   255, 255, 255, 3, 3, 3,
                                      255, 255, 255, 255, 255, 255, 255, 255, 255, 4, 4, 4};
  EXPECT_EQ(both.rgb, expected);
}

TEST(Report, MedianIsTheMiddle) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
}

TEST(Report, ResidentMemoryIsSeen) {
  const size_t before = residentBytes().now;
  const std::vector<char> block(64 << 20, 1);
  const ResidentBytes after = residentBytes();
  EXPECT_GE(after.now, before + (60u << 20)) << block.size();
  // Reads the block at the end, so that no compiler removes it.
  const volatile char* kept = block.data();
  EXPECT_EQ(kept[1 << 20], 1);
  EXPECT_GE(after.highest, after.now);
}

}  // namespace
}  // namespace gluray::bench
