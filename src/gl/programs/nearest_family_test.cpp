#include "gl/programs/nearest_family.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

Family familyOf(const std::string& name, const std::vector<std::string>& mentioned) {
  Family family;
  family.name = name;
  family.mentioned.insert(mentioned.begin(), mentioned.end());
  return family;
}

struct NearestFamilyTest : ::testing::Test {
  Program program;
  NearestFamily nearest;
  NearestFamilyTest() {
    program.attributes["position"] = {};
    program.uniforms["model"] = program.uniforms["view"] = {};
  }
};

TEST_F(NearestFamilyTest, MentionsMostOfTheProgramsVariables) {
  const Family one = familyOf("one", {"position", "x"}),
               two = familyOf("two", {"position", "view", "y", "z"});
  nearest.take(program, one, false, {"lacks \"x\""});
  nearest.take(program, two, false, {"lacks \"y\"", "lacks \"z\""});
  nearest.take(program, one, false, {"lacks \"x\""});
  EXPECT_EQ(nearest.text(), "; nearest: two, but it lacks \"y\", lacks \"z\"");
  EXPECT_FALSE(nearest.fitsButForCode());
}

TEST_F(NearestFamilyTest, HasTheFewestObstaclesAmongEquals) {
  const Family one = familyOf("one", {"view"}), two = familyOf("two", {"model"});
  nearest.take(program, one, false, {"a", "b", "c", "d", "e", "f"});
  EXPECT_EQ(nearest.text(), "; nearest: one, but it a, b, c, d and 2 more");
  nearest.take(program, two, false, {"a"});
  EXPECT_EQ(nearest.text(), "; nearest: two, but it a");
}

TEST_F(NearestFamilyTest, IsNotNamedIfItMentionsNothing) {
  const Family other = familyOf("other", {"x"});
  nearest.take(program, other, false, {"lacks \"x\""});
  EXPECT_EQ(nearest.text(), "");
}

TEST_F(NearestFamilyTest, FitsButForStatementsBeforeAllOthers) {
  Family code = familyOf("code", {"view"});
  code.code = {"section"};
  const Family more = familyOf("more", {"view", "model", "position"});
  nearest.take(program, code, true, {"has an unknown statement"});
  nearest.take(program, more, false, {"lacks \"x\""});
  EXPECT_TRUE(nearest.fitsButForCode());
  EXPECT_EQ(nearest.text().find("; nearest: code, but it has an unknown statement; statements that"), 0u);
}

TEST_F(NearestFamilyTest, IsTracedAndHasTheSameKindOfVertices) {
  Family never = familyOf("never", {"position"});
  never.rasteriseBecause = "a test";
  nearest.take(program, never, false, {"a"});
  EXPECT_EQ(nearest.text(), "");
}

}  // namespace
}  // namespace gluray::gl
