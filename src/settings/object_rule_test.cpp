#include "settings/object_rule.h"

#include "settings/rows.h"
#include "settings/values.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

ObjectRule read(std::string_view entry, const Settings::Material& otherwise = {}) {
  ObjectRule rule;
  EXPECT_EQ(readObjectRule(entry, otherwise, rule), "") << entry;
  return rule;
}

TEST(ObjectRuleTest, SaysWhatTheObjectIsMadeOf) {
  Settings::Material otherwise;
  otherwise.coat = 0.5f;
  const ObjectRule rule = read("3 metal metal=Au  roughness=0.1", otherwise);
  EXPECT_EQ(rule.object, 3u);
  EXPECT_TRUE(rule.looks);
  EXPECT_FALSE(rule.hiddenFrom);
  EXPECT_EQ(rule.material.kind, SurfaceMaterial::metal);
  EXPECT_EQ(rule.material.metal, SurfaceMetal::gold);
  EXPECT_FLOAT_EQ(rule.material.roughness, 0.1f);
  EXPECT_FLOAT_EQ(rule.material.coat, 0.5f);
}

TEST(ObjectRuleTest, SaysWhichRaysDoNotMeetIt) {
  const ObjectRule rule = read("7 hidden-from=camera+reflection");
  EXPECT_FALSE(rule.looks);
  EXPECT_EQ(rule.hiddenFrom, 0b1001);
  EXPECT_EQ(read("7 hidden-from=all").hiddenFrom, 0b1111);
  EXPECT_EQ(read("7 hidden-from=none").hiddenFrom, 0);
  EXPECT_FALSE(read("7").looks);
}

TEST(ObjectRuleTest, SaysWhatIsWrong) {
  EXPECT_EQ(checkObjectRule("glass"), "'glass': an entry begins with the number of an object, from 1");
  EXPECT_EQ(checkObjectRule("0 glass"), "'0 glass': an entry begins with the number of an object, from 1");
  EXPECT_EQ(checkObjectRule("3 roughnes=1"),
            "object 3: objects have no 'roughnes'; did you mean 'roughness'?");
  EXPECT_EQ(checkObjectRule("3 roughness=2"), "object 3: roughness=2: use a number from 0 to 1");
  EXPECT_EQ(checkObjectRule("3 file=x"), "object 3: objects have no 'file'");
  EXPECT_NE(checkObjectRule("3 gold").find("object 3: 'gold': use program, matte"), std::string::npos);
  EXPECT_NE(checkObjectRule("3 hidden-from=eye").find("hidden-from=eye: use all, none"), std::string::npos);
  EXPECT_NE(checkObjectRule("3 hidden-from="), "");
  EXPECT_NE(checkObjectRule("99999999999 glass"), "");
}

TEST(ObjectRuleTest, TheSettingTakesEntriesThatCanBeReadAlone) {
  const Row& row = *findSetting("material.objects");
  Session session;
  EXPECT_EQ(readValue(row, "3 glass,7 hidden-from=camera", session), "");
  EXPECT_EQ(printValue(row, session), "3 glass,7 hidden-from=camera");
  EXPECT_NE(readValue(row, "3 glass,7 glas", session), "");
  EXPECT_EQ(session.settings.material.objects.size(), 2u);
  EXPECT_TRUE(session.settings.changesImage());
}

using Words = std::vector<std::string>;

TEST(ObjectEntriesTest, WordsOfSeveralEntriesAreMerged) {
  const Words entries{"3 glass roughness=0.1", "7 matte", "3 hidden-from=camera",
                      " 3  ior=1.4  roughness=0.3"};
  EXPECT_EQ(wordsOf(entries, 3), (Words{"glass", "roughness=0.3", "ior=1.4", "hidden-from=camera"}));
  EXPECT_EQ(wordsOf(entries, 7), Words{"matte"});
  EXPECT_EQ(wordsOf(entries, 4), Words());
  EXPECT_EQ(wordsOf({"3 glass", "3 matte"}, 3), Words{"matte"});
  EXPECT_EQ(wordsOf({"glass", "", "x 3"}, 0), Words());
}

TEST(ObjectEntriesTest, WhatIsNotNamedStays) {
  const Words entries{"3 glass hidden-from=camera", "7 matte"};
  EXPECT_EQ(withObject(entries, 3, {"roughness=0.1"}),
            (Words{"3 glass roughness=0.1 hidden-from=camera", "7 matte"}));
  EXPECT_EQ(withObject(entries, 3, {"hidden-from=all"}), (Words{"3 glass hidden-from=all", "7 matte"}));
  EXPECT_EQ(withObject(entries, 7, {"hidden-from=shadow"}),
            (Words{"3 glass hidden-from=camera", "7 matte hidden-from=shadow"}));
}

TEST(ObjectEntriesTest, AMaterialForgetsTheValuesThatTheObjectHad) {
  const Words entries{"3 glass roughness=0.1 ior=1.4 hidden-from=camera"};
  EXPECT_EQ(withObject(entries, 3, {"matte"}), Words{"3 matte hidden-from=camera"});
  EXPECT_EQ(withObject(entries, 3, {"metal=Au", "metal"}), Words{"3 metal metal=Au hidden-from=camera"});
  EXPECT_EQ(withObject(entries, 3, {"glass"}), Words{"3 glass hidden-from=camera"});
}

TEST(ObjectEntriesTest, EntriesKeepTheirPlacesAndNewOnesComeLast) {
  const Words entries{"5 mirror", "3 glass", "5 coat=1", "7 matte"};
  EXPECT_EQ(withObject(entries, 5, {"roughness=0"}),
            (Words{"5 mirror coat=1 roughness=0", "3 glass", "7 matte"}));
  EXPECT_EQ(withObject(entries, 3, {"matte"}), (Words{"5 mirror", "3 matte", "5 coat=1", "7 matte"}));
  EXPECT_EQ(withObject({"5 mirror"}, 1, {"glass"}), (Words{"5 mirror", "1 glass"}));
  EXPECT_EQ(withObject({}, 1, {"glass"}), Words{"1 glass"});
}

TEST(ObjectEntriesTest, WithoutWordsThereIsNoEntry) {
  EXPECT_EQ(withObject({"3 glass", "7 matte", "3 coat=1"}, 3, {}), Words{"7 matte"});
  EXPECT_EQ(withObject({"7 matte"}, 3, {}), Words{"7 matte"});
}

TEST(ObjectEntriesTest, NothingAfterTheSignTakesTheValueOut) {
  EXPECT_EQ(withObject({"3 glass hidden-from=camera"}, 3, {"hidden-from="}), Words{"3 glass"});
  EXPECT_EQ(withObject({"3 glass", "3 ior=1.4"}, 3, {"ior="}), Words{"3 glass"});
  EXPECT_EQ(withObject({"3 hidden-from=camera", "7 matte"}, 3, {"hidden-from="}), Words{"7 matte"});
  EXPECT_EQ(withObject({}, 3, {"hidden-from="}), Words());
}

}  // namespace
}  // namespace gluray
