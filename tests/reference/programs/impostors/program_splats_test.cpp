// Point Gaussian as in VTK since 9.4: a billboard from a ball's covariance in normalised device coordinates.
#include "tests/reference/programs/impostors/point_gaussian.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

struct SplatCase {
  const char* name;
  PointGaussianView view;
  int draws = 1;
};
void PrintTo(const SplatCase& c, std::ostream* out) { *out << c.name; }

const SplatCase kSplatCases[] = {
    {"splats", {}},
    {"splats_parallel", {.parallel = true}},
    {"splats_stretched", {.stretch = {1.5f, 0.4f, 0.8f}}},
    {"splats_parallel_stretched", {.parallel = true, .stretch = {1.5f, 0.4f, 0.8f}}},
    // The farther from the middle, the longer they are.
    {"splats_wide_angle", {.radius = 0.2f, .field = 110}},
    // Off-diagonal covariances below 1e-6.
    {"splats_small", {.stretch = {2, 0.5f, 1}, .radius = 0.006f}},
    {"splats_offset", {.offset = -8}},
    {"splats_parallel_offset", {.parallel = true, .offset = -8}},
    {"splats_in_one_plane", {.flat = true}},
    {"splats_lowpass", {.lowpass = 0.01f}},
    {"splats_cut_by_their_cards", {.bounds = 0.7f}, 0},
    {"splats_pushed_back", {.offset = 5}, 0},
};

class ProgramSplats : public testing::TestWithParam<SplatCase> {};

TEST_P(ProgramSplats, AreWhatTheProgramComputes) {
  expectBoth(
      GetParam().name,
      [](Gl gl) { drawPointGaussian(gl, {.look = PointGaussian::Look::round}, GetParam().view); },
      GetParam().draws);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramSplats, testing::ValuesIn(kSplatCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
