// What settings hide of a scene, and scenes that they leave alone.
#include "render/ground/staged_scene.h"

#include "base/testing/temporary_folder.h"
#include "render/testing/test_ground.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::render {
namespace {

using test::kLitSize;
using test::plate;
using test::Traced;
using test::traceStaged;

/// The wall and a screen that shades it, under a rule.
Traced screenedBy(const std::string& rule, bool ao = false) {
  const test::TemporaryFolder folder;
  scene::Snapshot s =
      test::litView({test::wall(), test::parallelogram({0, 0, 2}, {0.3f, 0, 0}, {0, 0.3f, 0})},
                    test::Shader::fixedFunction, {0.5f, 0, 1, 0});
  s.instances[1].order = 1;
  s.settings.shadows.enabled = !ao;
  s.settings.ao.enabled = ao;
  s.settings.ao.radius = 10;
  s.settings.ao.samples = 64;
  s.settings.material.file = folder.write("rules.toml", rule);
  return traceStaged(s);
}

TEST(HiddenFrom, RulesHideObjectsFromTheCameraAlone) {
  const Traced all = screenedBy("[[rule]]\nobjects = [1]\n"),
               hidden = screenedBy("[[rule]]\nobjects = [1]\nhidden-from = [\"camera\"]\n");
  // The screen is seen in the middle, 3 away; its shadow falls on x = -1.
  EXPECT_LT(all.depth(32, 32), hidden.depth(32, 32));
  EXPECT_EQ(hidden.depth(32, 32), hidden.depth(60, 32)) << "the wall behind has its own depth";
  int shadow = 0;
  for (int x = 0; x < kLitSize; ++x) shadow += hidden.color(x, 32).r == 0;
  EXPECT_GE(shadow, 8) << "it still casts its shadow";
}

TEST(HiddenFrom, RulesTakeShadowsAndOcclusionAway) {
  const auto shadowOf = [](const Traced& t) {
    int count = 0;
    for (int x = 0; x < kLitSize; ++x) count += t.color(x, 32).r < 100;
    return count;
  };
  EXPECT_GE(shadowOf(screenedBy("")), 5);
  EXPECT_GE(shadowOf(screenedBy("[[rule]]\nobjects = [1]\nhidden-from = [\"occlusion\", \"reflection\"]\n")),
            5);
  EXPECT_EQ(shadowOf(screenedBy("[[rule]]\nobjects = [1]\nhidden-from = [\"shadow\"]\n")), 0);
  const auto beside = [](const Traced& t) { return t.color(46, 32).r; };
  const float open = beside(screenedBy("[[rule]]\nobjects = [1]\nhidden-from = [\"occlusion\"]\n", true));
  EXPECT_LT(beside(screenedBy("", true)), open);
  EXPECT_LT(beside(screenedBy("[[rule]]\nobjects = [1]\nhidden-from = [\"shadow\"]\n", true)), open);
}

TEST(StagedScene, IsTheSnapshotItselfWhereSettingsAskForNothing) {
  scene::Snapshot s = plate(GroundKind::off);
  s.ground = scene::GroundUse::none;
  const StagedScene staged(s);
  EXPECT_EQ(&staged.snapshot(), &s);
  EXPECT_TRUE(staged.hidden().empty());
}

}  // namespace
}  // namespace gluray::render
