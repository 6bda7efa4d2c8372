// Open Image Denoise, by stand-ins whose results are known.
#include "frame/refinement/oidn_filter.h"

#include "frame/refinement/denoiser.h"
#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gluray::frame {
namespace {

std::string standIn(const std::string& kind) { return std::string(GLURAY_FAKE_OIDN) + "/" + kind; }

TEST(OidnFilter, IsSearchedForWhereProgramsBringIt) {
  const std::vector<std::string> files = oidnFiles({"", "/conda", "/opt/view/bin"});
  const auto has = [&](const char* file) { return std::count(files.begin(), files.end(), file) == 1; };
  EXPECT_EQ(files.front(), "libOpenImageDenoise.so.2");
  EXPECT_TRUE(has("libOpenImageDenoise.so.1"));
  EXPECT_TRUE(has("/conda/lib/libOpenImageDenoise.so.2"));
  EXPECT_TRUE(has("/opt/view/lib/libOpenImageDenoise.so.1"));
  EXPECT_TRUE(has("/opt/view/bin/libOpenImageDenoise.so.2"));
  EXPECT_EQ(oidnFiles({"/no/such/file.so", "/conda", ""}), std::vector<std::string>{"/no/such/file.so"});
}

TEST(OidnFilter, FailuresSayWhatToDo) {
  OidnLibrary library;
  std::string why;
  EXPECT_FALSE(loadOidn({"/no/such/file.so", "", ""}, library, why));
  EXPECT_NE(why.find("GLURAY_OIDN=/no/such/file.so"), std::string::npos) << why;
  EXPECT_FALSE(loadOidn({standIn("lacks"), "", ""}, library, why));
  EXPECT_NE(why.find("oidnReleaseFilter"), std::string::npos) << why;
}

TEST(OidnFilter, DenoisesLightWithEitherVersion) {
  for (const char* kind : {"newer", "older"}) {
    OidnLibrary library;
    std::string why;
    ASSERT_TRUE(loadOidn({standIn(kind), "", ""}, library, why)) << why;
    scene::Snapshot s = test::litScene(test::Hides::half);
    s.settings.denoise = Denoise::filter;
    const test::Refined refined(s, 2);
    std::vector<float> out;
    ASSERT_TRUE(smoothByOidn(library, refined.refinement, 3, refined.image, 0, out, why)) << why;
    // Half of the sky is hidden from white planes, which fill the image.
    ASSERT_EQ(out.size(), 3 * refined.image.depth.size());
    for (const float value : out) ASSERT_NEAR(value, 0.5f, 0.03f);
  }
}

TEST(OidnFilter, FailsWithTheLibrarysReason) {
  OidnLibrary library;
  std::string why;
  ASSERT_TRUE(loadOidn({standIn("fails"), "", ""}, library, why)) << why;
  scene::Snapshot s = test::litScene();
  s.settings.denoise = Denoise::filter;
  const test::Refined refined(s, 2);
  std::vector<float> out;
  EXPECT_FALSE(smoothByOidn(library, refined.refinement, 3, refined.image, 0, out, why));
  EXPECT_EQ(why, "Open Image Denoise fails: out of order");
}

TEST(OidnFilter, AutoTakesItForFinishedImagesOfFewSamples) {
  const auto wanted = [](Denoise denoise, bool paths, int samples, int passes, int most) {
    scene::Snapshot s = test::litScene();
    s.settings.denoise = denoise;
    if (paths) s.settings.integrator = LightIntegrator::path;
    s.settings.path.samples = s.settings.ao.samples = samples;
    s.settings.refine.passes = most, s.settings.noise = 1e-6f;
    return wantsOidn(test::Refined(s, passes).refinement, s.settings);
  };
  EXPECT_TRUE(wanted(Denoise::automatic, true, 1, 4, 4));
  EXPECT_TRUE(wanted(Denoise::automatic, true, 4, 1, 1));
  EXPECT_FALSE(wanted(Denoise::automatic, true, 1, 1, 4));  // more passes follow
  EXPECT_FALSE(wanted(Denoise::automatic, true, 1, 5, 5));
  EXPECT_TRUE(wanted(Denoise::automatic, false, 4, 4, 4));
  EXPECT_FALSE(wanted(Denoise::automatic, false, 5, 4, 4));
  EXPECT_FALSE(wanted(Denoise::automatic, false, 4, 1, 1));  // the noise is unknown
  EXPECT_FALSE(wanted(Denoise::filter, true, 1, 1, 1));
  EXPECT_TRUE(wanted(Denoise::oidn, false, 4, 1, 4));
}

}  // namespace
}  // namespace gluray::frame
