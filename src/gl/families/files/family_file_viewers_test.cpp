// Family files: keys that viewers' shader programs need: colours by normals, positions of lights with a
// matrix, separate masking.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

const std::string kUnlit = "lights.model = \"unlit\"\n", kNormal = "vertex.normal = \"n\"\n";

TEST(FamilyFileViewers, Matcaps) {
  const Family f = parsed(kUnlit + "color.matcap = [\"r\", \"g\", \"b\", \"k\"]\ncolor.back_factor = 0.7\n");
  EXPECT_EQ(f.matcap, (std::vector<std::string>{"r", "g", "b", "k"}));
  EXPECT_EQ(f.backFactor.constant, std::vector<float>{0.7f});
  EXPECT_TRUE(f.mentions("k"));
  EXPECT_EQ(mistake(kMin + kUnlit + "color.matcap = [\"r\", \"g\"]\n"),
            "x.toml:1: family \"f\": color.matcap needs four samplers");
  EXPECT_EQ(mistakeIn("color.back_factor = 0.7"),
            "x.toml:1: family \"f\": color.matcap and color.back_factor are for the model unlit");
}

TEST(FamilyFileViewers, MapRanges) {
  const Family f = parsed("color.map = \"t\"\ncolor.map_low = \"lo\"\ncolor.map_high = 4\n");
  EXPECT_EQ(f.mapLow.uniform, "lo");
  EXPECT_EQ(f.mapHigh.constant, std::vector<float>{4});
}

TEST(FamilyFileViewers, Normals) {
  const Family f = parsed(kNormal + "normals.face_viewer = true\nnormals.flip_triangles = true\n");
  EXPECT_TRUE(f.facesViewer && f.flipsTriangles);
  EXPECT_EQ(parsed(kNormal + "normals.unit = \"never\"\ncolor.from_normals = true\n").unitNormals,
            scene::FragmentShading::UnitNormals::never);
  EXPECT_EQ(mistake(kMin + kNormal + "normals.unit = \"never\"\n"),
            "x.toml:1: family \"f\": normals.unit = \"never\" is for color.from_normals");
  EXPECT_EQ(
      mistakeIn("normals.face_viewer = true"),
      "x.toml:1: family \"f\": normals.unit, normals.face_viewer, color.from_normals and color.rim are for "
      "vertex normals alone");
}

TEST(FamilyFileViewers, NormalsOfInstances) {
  EXPECT_TRUE(parsed("instance.transform = \"i\"\ninstance.turns_normals = true\n").instanceTurnsNormals);
  EXPECT_EQ(mistakeIn("instance.turns_normals = true"),
            "x.toml:6: turns_normals needs transform, without normal_matrix");
}

TEST(FamilyFileViewers, Lights) {
  const Family f = parsed(
      "lights.color = \"c.{}\"\nlights.position = \"p.{}\"\nlights.position_matrix = [\"v\", \"w\"]\n"
      "lights.intensity = \"d.{}\"\nlights.highlight_intensity = 0.5\n");
  EXPECT_EQ(f.lights.positionMatrix, (std::vector<std::string>{"v", "w"}));
  EXPECT_EQ(f.lights.intensity.uniform, "d.{}");
  EXPECT_EQ(f.lights.highlightIntensity.constant, std::vector<float>{0.5f});
  for (const char* name : {"c", "p", "v", "w", "d"}) EXPECT_TRUE(f.mentions(name)) << name;
  EXPECT_EQ(
      mistakeIn("lights.highlight_intensity = 1"),
      "x.toml:1: family \"f\": lights.highlight_intensity needs lights.color, without lights.specular_color");
  EXPECT_EQ(mistakeIn("lights.position_matrix = \"v\""),
            "x.toml:1: family \"f\": lights.position_matrix needs lights.position");
}

TEST(FamilyFileViewers, SeparateMasking) {
  const std::string pbr = "lights.model = \"pbr\"\npbr.roughness = 0.5\n";
  const Family f = parsed(pbr + "pbr.masking = \"separate\"\npbr.ambient = \"a\"\n");
  EXPECT_EQ(f.pbr.masking, scene::PbrSurface::Masking::separate);
  EXPECT_EQ(f.pbr.ambient.uniform, "a");
  const std::string wrong =
      "x.toml:1: family \"f\": pbr.masking = \"separate\", and no other, has pbr.ambient, and it has no "
      "textures";
  EXPECT_EQ(mistake(kMin + pbr + "pbr.ambient = 1\n"), wrong);
  EXPECT_EQ(mistake(kMin + pbr + "pbr.masking = \"separate\"\ncolor.textures = \"t\"\n"), wrong);
}

}  // namespace
}  // namespace gluray::gl
