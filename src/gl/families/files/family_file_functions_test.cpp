// Family files: matrices that are functions, products of values, windows.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

const std::string kEyeByFunction = "transform.eye_from_object = \"$eye\"\n",
                  kWrong = "x.toml:1: family \"f\": ";

TEST(FamilyFileFunctions, ProductsOfValues) {
  const Family f = parsed("material.opacity = \"tint.a * fade * more.g\"\nmaterial.shininess = \"s\"\n");
  EXPECT_EQ(f.material.opacity.uniform, "tint.a");
  EXPECT_EQ(f.material.opacity.factors, (std::vector<std::string>{"fade", "more.g"}));
  EXPECT_TRUE(f.material.shininess.factors.empty());
  for (const char* name : {"tint", "fade", "more", "s"}) EXPECT_TRUE(f.mentions(name)) << name;
  EXPECT_FALSE(f.mentions("tint.a * fade * more.g"));
}

TEST(FamilyFileFunctions, LinesOfSight) {
  const Family f =
      parsed("lights.viewer = \"vertices\"\nlights.highlights_need_shininess = true\nmatch.code = \"any\"\n");
  EXPECT_TRUE(f.lights.viewerAtVertices && f.lights.highlightsNeedShininess && !f.lights.infiniteViewer);
  EXPECT_EQ(mistakeIn("transform.lines_of_sight = \"$s\""),
            kWrong +
                "transform.lines_of_sight needs match.code and transform.eye_from_object, without "
                "transform.viewer");
  EXPECT_EQ(mistakeIn("transform.eye_again = [\"$a\", \"$b\"]"),
            kWrong + "transform.eye_again needs transform.eye_from_object");
  EXPECT_EQ(mistake(kMin + kEyeByFunction + "vertex.normal = \"n\"\nnormals.by_derivatives = true\n"),
            kWrong + "normals.by_derivatives needs transform.eye_from_object, without vertex.normal");
  EXPECT_EQ(mistakeIn("lights.viewer = \"vertices\"\nlights.model = \"unlit\""),
            kWrong +
                "lights.clamped, lights.viewer, lights.half_vector, lights.highlights_need_shininess and "
                "normals.dark_back_faces are for the model phong");
}

TEST(FamilyFileFunctions, Windows) {
  const Family f = parsed("clip.window = \"w\"\nclip.window_from_pixels = \"$w\"\n");
  EXPECT_EQ(f.clipWindow, "w");
  EXPECT_EQ(f.windowFromPixels, "$w");
  EXPECT_EQ(mistakeIn("clip.window = \"w\""),
            kWrong + "clip.window and clip.window_from_pixels need each other");
}

}  // namespace
}  // namespace gluray::gl
