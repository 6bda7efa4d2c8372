// The user's family files: which families apply, in which order, and error messages.
#include "intercept/session/families.h"

#include "settings/values.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gluray::intercept {
namespace {

std::vector<std::string> g_complaints;

class Families : public testing::Test {
 protected:
  Families() : folder_(testing::TempDir() + "gluray-families-" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
    g_complaints.clear();
  }
  ~Families() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static std::shared_ptr<const gl::FamilyList> read(const std::string& files) {
    Session session;
    readValue(*findSetting("program-families"), files, session);
    return readFamilies(session.programFamilies,
                        [](const std::string& line) { g_complaints.push_back(line); });
  }
  std::filesystem::path folder_;
};

std::string family(const std::string& name) {
  return "[[family]]\nname = \"" + name + "\"\nmatch.active = [\"a\"]\nvertex.position = \"a\"\n" +
         "transform.clip_from_object = \"m\"\n";
}

TEST_F(Families, NoFilesLeaveTheBuiltInOnes) {
  EXPECT_EQ(read(""), nullptr);
  EXPECT_EQ(read("::"), nullptr);
  EXPECT_TRUE(g_complaints.empty());
}

TEST_F(Families, ComeBeforeTheBuiltInOnesInTheirOrder) {
  const auto all = read(file("one.toml", family("1") + family("2")) + ":" + file("two.toml", family("3")));
  ASSERT_NE(all, nullptr);
  const gl::FamilyList& known = gl::builtInFamilies();
  ASSERT_EQ(all->size(), 3 + known.size());
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ((*all)[i]->name, std::to_string(i + 1));
  EXPECT_TRUE(std::equal(known.begin(), known.end(), all->begin() + 3));
  EXPECT_TRUE(g_complaints.empty());
}

TEST_F(Families, SectionsOfCodeMayBeInAnyFile) {
  const std::string named = family("1") + "match.code = [\"VTK\", \"theirs\"]\n";
  const std::string one = file("one.toml", named);
  EXPECT_EQ(read(one), nullptr);
  ASSERT_EQ(g_complaints.size(), 1u);
  EXPECT_EQ(g_complaints[0].rfind(one + ":6: there is no [[code]] section \"theirs\"", 0), 0u)
      << g_complaints[0];
  g_complaints.clear();
  const auto all = read(one + ":" + file("two.toml", "[[code]]\nname = \"theirs\"\nstatements = \"a;\"\n"));
  ASSERT_NE(all, nullptr);
  EXPECT_TRUE(g_complaints.empty());
  EXPECT_EQ(all->front()->name, "1");
}

TEST_F(Families, MistakesInSlotsOfBuiltInSectionsAreTheFiles) {
  const std::string code = "[[code]]\nname = \"VTK volume\"\n",
                    good = code + "[[code.fragments]]\nslot = \"blend\"\nword = \"additive\"\nend = \"a;\"\n";
  const std::string word =
                        file("one.toml", code + "[[code.fragments]]\nslot = \"blend\"\nword = \"largest\"\n"),
                    slot = file("two.toml", code + "statements = \"a = @largest;\"\n");
  const auto all = read(word + ":" + slot + ":" + file("three.toml", good));
  ASSERT_NE(all, nullptr);
  const std::vector<std::string> expected{
      word + ":5: the word \"largest\" of the slot \"@blend\" is no value of volume.blend",
      slot + ":3: the slot \"@largest\" has no fragments"};
  EXPECT_EQ(g_complaints, expected);
  const gl::SlotFragments& fragments = all->code.at("VTK volume").fragments();
  EXPECT_EQ(fragments.groups().at("blend").front().word, "additive") << "the file's own come first";
}

TEST_F(Families, FamiliesThatNeedSectionsOfAMissingFileAreDropped) {
  const std::string two =
      family("2") + "match.code = \"ghost\"\n[[code]]\nname = \"of two\"\nstatements = \"a;\"\n";
  const auto all = read(file("one.toml", family("1") + "match.code = \"of two\"\n") + ":" +
                        file("two.toml", two) + ":" + file("three.toml", family("3")));
  ASSERT_NE(all, nullptr);
  EXPECT_EQ(g_complaints.size(), 2u);
  EXPECT_EQ(all->front()->name, "3");
}

TEST_F(Families, AFileWithAMistakeIsReportedInOneLineAndAddsNothing) {
  const std::string bad = file("bad.toml", family("1") + "\n[[family]]\nname = \"2\"\nmatsch.active = []\n");
  const auto all = read(bad + ":" + file("good.toml", family("3")));
  ASSERT_EQ(g_complaints.size(), 1u);
  EXPECT_EQ(g_complaints[0].rfind(bad + ":", 0), 0u) << g_complaints[0];
  EXPECT_EQ(g_complaints[0].find('\n'), std::string::npos);
  ASSERT_NE(all, nullptr);
  EXPECT_EQ(all->front()->name, "3");
  EXPECT_EQ(all->size(), 1 + gl::builtInFamilies().size());
}

TEST_F(Families, UnreadableFilesAreReported) {
  EXPECT_EQ(read("/nowhere/x.toml:" + folder_.string()), nullptr);
  ASSERT_EQ(g_complaints.size(), 2u);
  EXPECT_EQ(g_complaints[0], "/nowhere/x.toml: No such file or directory");
  EXPECT_EQ(g_complaints[1], folder_.string() + ": Is a directory");
}

}  // namespace
}  // namespace gluray::intercept
