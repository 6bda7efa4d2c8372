// Whether programs fit a family, judged by the names of their variables.
#include "gl/programs/renames.h"
#include "gl/testing/test_match.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

TEST_F(Match, ProgramMayLackVariablesOfTheFamily) {
  EXPECT_EQ(obstaclesOf(fitting()), Lines{});
  Program p = fitting();
  p.uniforms["time"].type = GL_FLOAT;
  p.uniforms["light17"].type = GL_FLOAT_VEC3;
  p.uniforms["place"].type = GL_FLOAT_VEC3;
  p.uniforms["map"].type = GL_SAMPLER_2D;
  p.uniforms["nm"].type = GL_FLOAT_MAT3;
  p.attributes["c"].type = GL_FLOAT_VEC4;
  EXPECT_EQ(obstaclesOf(p), Lines{});
}

TEST_F(Match, ReportsMissingVariables) {
  Program p = fitting();
  p.linked = false;
  EXPECT_EQ(obstaclesOf(p), Lines{"is not linked"});
  p = fitting();
  p.attributes.erase("n");
  EXPECT_EQ(obstaclesOf(p), Lines{"lacks attribute \"n\""});
  p.attributes.erase("p");
  EXPECT_EQ(obstaclesOf(p), (Lines{"lacks \"p\"", "lacks attribute \"p\"", "lacks attribute \"n\""}));
  p = fitting();
  p.uniforms.erase("m");
  EXPECT_EQ(obstaclesOf(p), (Lines{"lacks \"m\"", "lacks uniform \"m\""}));
}

TEST_F(Match, ReportsUnwantedVariables) {
  Program p = fitting();
  p.uniforms["bad"].type = GL_FLOAT;
  EXPECT_EQ(obstaclesOf(p),
            (Lines{"has \"bad\"", "has uniform \"bad\" (float), which the family does not describe"}));
  p = fitting();
  p.attributes["bone"].type = GL_FLOAT;
  EXPECT_EQ(obstaclesOf(p), Lines{"has attribute \"bone\" (float), which the family does not describe"});
  p = fitting();
  p.geometryShader = p.tessellation = p.writes = true;
  EXPECT_EQ(obstaclesOf(p),
            (Lines{"has a geometry shader", "has tessellation shaders", "writes into buffers or images"}));
  g_outputs["second"] = 1;
  EXPECT_EQ(obstaclesOf(fitting()), Lines{"has output \"second\""});
}

TEST_F(Match, TypesMustFitTheirRole) {
  const auto with = [&](const char* name, GLenum type) {
    Program p = fitting();
    p.uniforms[name].type = type;
    return obstaclesOf(p);
  };
  EXPECT_EQ(with("m", GL_FLOAT_MAT3), Lines{"has \"m\", which is not a mat4"});
  EXPECT_EQ(with("m", GL_FLOAT_VEC4), Lines{"has \"m\", which is not a mat4"});
  EXPECT_EQ(with("v", GL_FLOAT_MAT4x3), Lines{"has \"v\", which is not a mat3 or mat4"});
  EXPECT_EQ(with("nm", GL_FLOAT_VEC3), Lines{"has \"nm\", which is not a mat3 or mat4"});
  EXPECT_EQ(with("dc", GL_FLOAT_MAT3), Lines{"has \"dc\", which is not a number or vector"});
  EXPECT_EQ(with("dc", GL_FLOAT), Lines{});
  EXPECT_EQ(with("map", GL_INT_SAMPLER_2D), Lines{"has \"map\", which is not a sampler"});
  EXPECT_EQ(with("cells", GL_SAMPLER_2D), Lines{"has \"cells\", which is not a samplerBuffer"});
  EXPECT_EQ(with("light0", GL_FLOAT), Lines{"has \"light0\", which is not a vector"});
  EXPECT_EQ(with("place", GL_FLOAT_MAT4), Lines{"has \"place\", which is not a vector"});
  EXPECT_EQ(with("lights", GL_FLOAT_VEC2), Lines{"has \"lights\", which is not a number"});
  EXPECT_EQ(with("time", GL_DOUBLE), Lines{"has \"time\" in double precision"});
  Program p = fitting();
  p.attributes["p"].type = GL_INT_VEC3;
  EXPECT_EQ(obstaclesOf(p), Lines{"has \"p\", which is not a vector"});
}

TEST_F(Match, AlternativesReplaceMissingNames) {
  std::string text = kFamily;
  text.replace(text.find("\"p\"\nvertex.normal"), 3, "[\"p\", \"place2\", \"place3\"]");
  text.replace(text.find("= \"map\""), 7, "= [\"map\", \"colors\"]");
  const auto family = parseFamilies(text, "f.toml").front();
  Program p = fitting();
  p.attributes.erase("p"), p.attributes["place3"].type = GL_FLOAT_VEC3;
  p.uniforms["colors"].type = GL_SAMPLER_2D;
  EXPECT_EQ(obstacles(real_, p, *family), Lines{});
  p.renamed = renamedBy(p, *family);
  EXPECT_EQ(p.attribute("p"), &p.attributes.at("place3"));
  EXPECT_EQ(p.uniform("map"), &p.uniforms.at("colors"));
  p.attributes["place2"].type = GL_FLOAT_VEC3;
  EXPECT_EQ(obstacles(real_, p, *family),
            Lines{"has attribute \"place3\" (vec3), which the family does not describe"})
      << "the first existing alternative replaces the name, and no other";
  p.attributes["p"].type = GL_FLOAT_VEC3, p.attributes.erase("place2"), p.attributes.erase("place3");
  p.uniforms["colors"].type = GL_FLOAT_MAT4;
  EXPECT_EQ(obstacles(real_, p, *family), Lines{"has \"map\", which is not a sampler"});
}

TEST_F(Match, RecognisedProgramsKeepOnlyTheirOwnFamilysRenames) {
  FamilyList list = parseFamilies(
      "[[family]]\nname = \"far\"\nmatch.active = [\"p\", \"q\"]\nvertex.position = [\"q\", \"n\"]\n"
      "transform.clip_from_object = \"m\"\n",
      "f.toml");
  const Program p = fitting();
  EXPECT_FALSE(renamedBy(p, *list.front()).empty());
  EXPECT_TRUE(renamedBy(p, *family_).empty());
}

}  // namespace
}  // namespace gluray::gl
