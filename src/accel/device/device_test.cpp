// The memory that structures are measured by.
#include "accel/device/device.h"

#include "accel/meshes/blas.h"
#include "accel/testing/test_scene.h"
#include "base/sanitized.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace gluray::accel {
namespace {

// Refined structures and pages are built in a BehindScope, and freed wherever their last user is.
TEST(Device, StructuresAreMeasuredAfterOthersWereFreedOutsideTheirScopes) {
  const Device device;
  IotaIndices iota;
  const auto mesh = test::scatteredTriangles(20000);
  const auto measured = [&] {
    Blas blas(device, iota, {mesh.get(), {}}, BvhQuality::full);
    blas.build();
    return static_cast<double>(blas.bvhBytes());
  };
  const double expected = measured();
  EXPECT_GT(expected, 20000.0);
  const size_t before = Device::bytes();
  for (int i = 0; i < 20; ++i) Blas::buildAlone(device, iota, {mesh.get(), {}}, BvhQuality::full);
  EXPECT_LT(Device::bytes(), before + 20000) << "they are freed";
  EXPECT_NEAR(measured(), expected, 0.2 * expected);
}

/// Address space of this process in bytes.
size_t mappedBytes() {
  size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

// Limits of address space are met by what is mapped, not by what is used.
TEST(Device, MapsNoCacheForSurfacesThatWeDoNotHave) {
  if (kSanitized) GTEST_SKIP() << "sanitizers map memory of their own";
  const size_t before = mappedBytes();
  const Device device;
  EXPECT_LT(mappedBytes(), before + (size_t{64} << 20));
}

}  // namespace
}  // namespace gluray::accel
