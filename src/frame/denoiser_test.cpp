// Pictures smoothed: nearer to converged ones, and to the bit where nothing is noisy.
#include "frame/denoiser.h"

#include "frame/lit_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::frame {
namespace {

using test::difference, test::litScene;

/// A picture of so many passes.
struct Refined {
  test::CountingTrace tracer;
  Refinement refinement;
  Image image;
  scene::TraceCost cost;
  std::string error;
  Refined(const scene::Snapshot& s, int passes) {
    Refiner refiner(s, refinement);
    for (int i = 0; i < passes; ++i) EXPECT_TRUE(refiner.pass(tracer.trace, 0, cost, error)) << error;
    refiner.show(image);
  }
};

scene::Snapshot smoothed(scene::Snapshot s) {
  s.settings.denoise = Denoise::filter;
  return s;
}

double dB(const Image& a, const Image& b) { return -20 * std::log10(difference(a, b)); }

scene::Snapshot pathScene(int size) {
  scene::Snapshot s = litScene(test::Hides::some, size);
  s.settings.ao.enabled = false;
  s.settings.integrator = LightIntegrator::path;
  s.settings.path.samples = 2;
  for (scene::Instance& instance : s.instances) instance.color = {0.9f, 0.6f, 0.3f, 1};
  return s;
}

TEST(Denoiser, BringsFewPassesNearerToTheConvergedPicture) {
  for (const bool paths : {false, true}) {
    scene::Snapshot s = paths ? pathScene(96) : litScene(test::Hides::some, 96);
    scene::Snapshot many = s;
    many.settings.ao.samples = 2048, many.settings.path.samples = 2048;
    const Image truth = test::CountingTrace().picture(many);
    for (const int passes : {1, 4, 16}) {
      const double plain = dB(Refined(s, passes).image, truth),
                   filtered = dB(Refined(smoothed(s), passes).image, truth);
      std::printf("%d %d: %g -> %g dB\n", paths, passes, plain, filtered);
      EXPECT_GT(filtered, plain + 1) << paths << ' ' << passes;
    }
  }
}

}  // namespace
}  // namespace gluray::frame
