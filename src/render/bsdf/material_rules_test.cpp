// Rules that give objects materials.
#include "render/bsdf/material_rules.h"

#include "accel/testing/test_scene.h"
#include "base/testing/temporary_folder.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace gluray::render {
namespace {

std::vector<MaterialRule> rules(const std::string& text) { return readMaterialRules(text, {}, 10); }

TEST(MaterialRules, SayWhatTheyHoldForAndWhatItIs) {
  const auto all = rules(R"(
[[rule]]
objects = [1, 3]
color = "#ff8000"
triangles = [10, 20]
material = "metal"
metal = "Cu"
roughness = 0.1
[[rule]]
material = "thin-glass"
ior = 1.3
absorption = 0.5
[[rule]]
material = "emissive"
emission = 4
)");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].model.kind, SurfaceMaterial::metal);
  EXPECT_EQ(all[0].model.metal, SurfaceMetal::copper);
  EXPECT_FLOAT_EQ(all[0].model.roughness, 0.1f);
  EXPECT_FLOAT_EQ(all[0].color->g, 128 / 255.0f);
  EXPECT_EQ(all[1].model.kind, SurfaceMaterial::thinGlass);
  EXPECT_FLOAT_EQ(all[1].model.absorption, 5);
  EXPECT_TRUE(all[2].model.isEmissive());
  EXPECT_FLOAT_EQ(all[2].model.emission, 4);
  scene::Instance instance;
  auto mesh = std::make_shared<scene::Mesh>();
  instance.mesh = mesh;
  mesh->triangleCount = 15;
  instance.order = 3;
  instance.color = {1, 128 / 255.0f, 0, 1};
  instance.materials.resize(1);
  EXPECT_TRUE(all[0].holdsFor(instance, {}));
  instance.order = 2;
  EXPECT_FALSE(all[0].holdsFor(instance, {}));
  instance.order = 3;
  mesh->triangleCount = 21;
  EXPECT_FALSE(all[0].holdsFor(instance, {}));
  EXPECT_TRUE(all[1].holdsFor(instance, {}));
}

TEST(MaterialRules, HideObjectsFromKindsOfRays) {
  const auto all =
      rules("[[rule]]\nhidden-from = [\"camera\", \"reflection\"]\n[[rule]]\nhidden-from = []\n");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].hiddenFrom,
            accel::bitOf(accel::RayKind::camera) | accel::bitOf(accel::RayKind::reflection));
  EXPECT_EQ(all[1].hiddenFrom, 0);
  EXPECT_FALSE(all[0].looks) << "materials stay";
}

TEST(MaterialRules, MistakesAreNamedWithTheirLine) {
  const auto why = [](const std::string& text) -> std::string {
    try {
      rules(text);
    } catch (const std::runtime_error& e) { return e.what(); }
    return "";
  };
  EXPECT_EQ(why("[[rule]]\nmaterial = \"gold\"\n"), "line 2: 'gold' is none of the choices");
  EXPECT_TRUE(why("[[rule]]\n\nroughness = 2\n").starts_with("line 3: a number from"));
  EXPECT_EQ(why("[[rule]]\nshine = 2\n"), "line 2: rules have no 'shine'");
  EXPECT_TRUE(why("[[rule]]\nobjects = [-1]\n").starts_with("line 2:"));
  EXPECT_TRUE(why("[[rule]]\ncolor = \"red\"\n").starts_with("line 2:"));
  EXPECT_TRUE(why("[[rule]]\ntriangles = [1]\n").starts_with("line 2:"));
  EXPECT_EQ(why("[[rule]]\nhidden-from = [\"light\"]\n"), "line 2: 'light' is none of the choices");
  EXPECT_TRUE(why("[[rule]]\nhidden-from = \"camera\"\n").starts_with("line 2: a list of kinds"));
  EXPECT_TRUE(why("roughness = 1\n").starts_with("line 1:"));
  EXPECT_TRUE(why("[[rule\n").starts_with("line 1:"));
}

TEST(MaterialRules, LaterRulesWinAndUnlitSurfacesStayUnlessARuleNamesThem) {
  scene::Snapshot s =
      test::makeSnapshot({test::makeMesh(test::squareData()), test::makeMesh(test::squareData(0.5f)),
                          test::makeMesh(test::squareData(0.7f))});
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].lighting = true;
  s.instances[1].shading = s.instances[2].shading = 1;
  s.instances[1].order = 1, s.instances[2].order = 2;
  s.instances[2].materials[0].front.diffuse = {1, 0, 0, 1};
  s.settings.material.kind = SurfaceMaterial::plastic;
  std::vector<MaterialModel> models = materialsOf(s, 1);
  EXPECT_EQ(models[0].kind, SurfaceMaterial::program);
  EXPECT_EQ(models[1].kind, SurfaceMaterial::plastic);
  std::optional<test::TemporaryFolder> folder(std::in_place);
  s.settings.material.file = folder->write(
      "rules.toml",
      "[[rule]]\nobjects = [0, 2]\nmaterial = \"glass\"\n[[rule]]\ncolor = \"#ff0000\"\nmaterial = "
      "\"mirror\"\n");
  models = materialsOf(s, 1);
  EXPECT_EQ(models[0].kind, SurfaceMaterial::glass);
  EXPECT_EQ(models[1].kind, SurfaceMaterial::plastic);
  EXPECT_EQ(models[2].kind, SurfaceMaterial::mirror);
  folder.reset();
  s.settings.material.file = "/no/such/folder/rules.toml";
  EXPECT_EQ(materialsOf(s, 1)[2].kind, SurfaceMaterial::mirror) << "the last rules that could be read stay";
}

TEST(MaterialRules, EntriesOfSingleObjectsWinAndFollowTheObject) {
  scene::Snapshot s =
      test::makeSnapshot({test::makeMesh(test::squareData()), test::makeMesh(test::squareData(0.5f)),
                          test::makeMesh(test::squareData(0.7f))});
  s.instances[0].object = {7}, s.instances[1].object = {3}, s.instances[2].ground = true;
  s.settings.material.roughness = 0.4f;
  s.settings.material.objects = {"3 glass ior=1.3", "7 hidden-from=camera+shadow", "3 hidden-from=none",
                                 "0 x"};
  const std::vector<MaterialModel> models = materialsOf(s, 1);
  EXPECT_EQ(models[0].kind, SurfaceMaterial::program);
  EXPECT_EQ(models[1].kind, SurfaceMaterial::glass);
  EXPECT_FLOAT_EQ(models[1].ior, 1.3f);
  EXPECT_FLOAT_EQ(models[1].roughness, 0.4f);
  EXPECT_EQ(hiddenByRules(s), (accel::HiddenFrom{3, 0, 0}));
  s.settings.material.objects = {"3 glass roughness=0.2", "3 matte"};
  EXPECT_EQ(materialsOf(s, 1)[1].kind, SurfaceMaterial::matte);
  EXPECT_FLOAT_EQ(materialsOf(s, 1)[1].roughness, 0.2f) << "later entries add to earlier ones";
  EXPECT_TRUE(hiddenByRules(s).empty());
}

}  // namespace
}  // namespace gluray::render
