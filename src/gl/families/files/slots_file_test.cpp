// [[code.fragments]] of family files, and keys that get their words from slots.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

/// A family whose key volume.blend is that of "@blend", with sections "c" and "d", and more lines.
std::string slotText(const std::string& more = "") {
  return kMin +
         "match.code = [\"c\", \"d\"]\nvolume.grid = \"g\"\nvolume.opacity = \"o\"\nvolume.color = \"k\"\n"
         "volume.texture_from_data = \"t\"\nvolume.step = \"s\"\nvolume.blend = \"@blend\"\n"
         "[[code]]\nname = \"c\"\nstatements = \"vec4 f() { @blend.start @crop return c; }\"\n"
         "[[code]]\nname = \"d\"\n"
         "[[code.fragments]]\nslot = \"crop\"\nword = \"on\"\ntext = \"n = 0;\"\n"
         "[[code.fragments]]\nslot = \"blend\"\nword = \"maximum\"\nstart = \"c = 0.0;\"\n" +
         more;
}

/// slotText() with more lines, of one more [[code.fragments]] that begins in line 26.
std::string withFragments(const std::string& lines) { return slotText("[[code.fragments]]\n" + lines); }

/// The error of parseFamilies() and needSections() for a file x.toml; "none" if there is none.
std::string slotMistake(const std::string& text) {
  try {
    const FamilyList list = parseFamilies(text, "x.toml");
    needSections(list, list.code);
  } catch (const FamilyError& e) { return e.what(); }
  return "none";
}

TEST(SlotsFile, ReadsFragments) {
  FamilyList list =
      parseFamilies(withFragments("slot = \"blend\"\nword = \"maximum\"\n"
                                  "required = true\nstart = \"c = 1.0f;\"\nend = \"d; // comment\"\n"),
                    "x.toml");
  list.append(
      parseFamilies("[[code]]\nname = \"d\"\n[[code.fragments]]\nslot = \"blend\"\n"
                    "word = \"additive\"\nstart = \"c = 2.;\"\n",
                    "y.toml"));
  needSections(list, list.code);
  Slots slots;
  slots.add(list.code.at("d").fragments());
  EXPECT_EQ(slots.words("blend"), (std::vector<std::string>{"maximum", "additive"}));
  std::vector<std::string> texts;
  for (const char* const part : {"start", "end"})
    slots.findFragment("blend", part, [&](const PatternText& text) {
      texts.push_back(text.text());
      return false;
    });
  EXPECT_EQ(texts, (std::vector<std::string>{"c=0.;", "c=1.;", "c=2.;", "d;"}));
  EXPECT_TRUE(slots.has("crop", ""));
  EXPECT_FALSE(slots.has("blend", "required"));
  EXPECT_TRUE(list.code.at("d").fragments().isRequired("blend"));
  EXPECT_FALSE(list.code.at("d").fragments().isRequired("crop"));
  EXPECT_FALSE(slots.has("crop", "start"));
}

TEST(SlotsFile, MistakesInFragmentsAreNamed) {
  EXPECT_EQ(slotMistake(slotText()), "none");
  const auto with = [](const std::string& lines) { return slotMistake(withFragments(lines)); };
  const std::string noSlot = "x.toml:26: fragments need a slot, a name of letters, digits and _";
  EXPECT_EQ(with("word = \"a\"\n"), noSlot);
  EXPECT_EQ(with("slot = \"1a\"\nword = \"a\"\n"), noSlot);
  EXPECT_EQ(with("slot = \"a\"\n"), "x.toml:26: fragments need a word");
  EXPECT_EQ(with("slot = \"a\"\nword = \"a\"\n\"a-b\" = \"\"\n"),
            "x.toml:29: \"a-b\" is no name of a part of a slot");
  EXPECT_EQ(with("slot = \"a\"\nword = \"a\"\nb = 1\n"), "x.toml:29: b must be a text in quotes");
  EXPECT_EQ(with("slot = \"a\"\nword = \"a\"\nrequired = 1\n"), "x.toml:29: required must be true or false");
  EXPECT_EQ(mistake("[[code]]\nname = \"c\"\nfragments = 1\n"),
            "x.toml:3: fragments must be sections, [[...]]");
  EXPECT_EQ(mistake("[[code]]\nname = \"c\"\nstatements = \"a = @;\"\n"),
            "x.toml:3: \"@\" is no name of a slot");
  EXPECT_EQ(mistake("[[code]]\nname = \"c\"\nblocks = \"a = @2b;\"\n"),
            "x.toml:3: \"@2b\" is no name of a slot");
  EXPECT_EQ(with("slot = \"crop\"\nword = \"off\"\ntext = \"a; @crop.b\"\n"),
            "x.toml:29: fragments of the slot \"@crop\" have this slot themselves");
}

TEST(SlotsFile, SlotsMustFitTogether) {
  const auto with = [](const std::string& lines) { return slotMistake(withFragments(lines)); };
  EXPECT_EQ(with("slot = \"crop\"\nword = \"off\"\ntext = \"a; @blend.start\"\n"), "none");
  EXPECT_EQ(with("slot = \"crop\"\nword = \"off\"\ntext = \"a; @blend.end\"\n"),
            "x.toml:29: the slot \"@blend.end\" has no fragments");
  EXPECT_EQ(with("slot = \"crop\"\nword = \"off\"\ntext = \"a; @blend.start\"\n"
                 "[[code.fragments]]\nslot = \"blend\"\nword = \"minimum\"\nstart = \"b; @crop\"\n"),
            "x.toml:29: fragments of the slot \"@crop\" have this slot themselves");
  EXPECT_EQ(with("slot = \"blend\"\nword = \"largest\"\nstart = \"b;\"\n"),
            "x.toml:28: the word \"largest\" of the slot \"@blend\" is no value of volume.blend");
  const auto replaced = [](const std::string& from, const std::string& to) {
    std::string text = slotText();
    text.replace(text.find(from), from.size(), to);
    return slotMistake(text);
  };
  EXPECT_EQ(replaced("@crop return", "@clip return"), "x.toml:15: the slot \"@clip\" has no fragments");
  EXPECT_EQ(replaced("blend = \"@blend\"", "blend = \"@mode\""),
            "x.toml:6: volume.blend: the slot \"@mode\" has no fragments");
  EXPECT_EQ(replaced("blend = \"@blend\"", "blend = \"@blend.start\""),
            "x.toml:6: volume.blend: \"@blend.start\" is no name of a slot");
}

TEST(SlotsFile, FilesMayAddToSlotsOfOthers) {
  const FamilyList first = parseFamilies(slotText(), "x.toml");
  const auto added = [&](const std::string& text) -> std::string {
    const FamilyList more = parseFamilies(text, "y.toml");
    FamilyList all = first;
    all.append(more);
    try {
      needSlots(first, more.code, all.code);
    } catch (const FamilyError& e) { return e.what(); }
    return "none";
  };
  EXPECT_EQ(added("[[code]]\nname = \"c\"\nstatements = \"f = @crop;\"\n"), "none");
  EXPECT_EQ(added("[[code]]\nname = \"c\"\nstatements = \"f = @clip;\"\n"),
            "y.toml:3: the slot \"@clip\" has no fragments");
  EXPECT_EQ(added("[[code]]\nname = \"e\"\nstatements = \"f = @clip;\"\n"), "none") << "no family has it";
}

TEST(SlotsFile, TheBlendOfAVolumeMayBeThatOfASlot) {
  const FamilyList list = parseFamilies(slotText("[[family]]\ninherits = \"f\"\nname = \"same\"\n"
                                                 "[[family]]\ninherits = \"f\"\nname = \"other\"\n"
                                                 "volume.blend = \"additive\"\n"),
                                        "x.toml");
  const FamilyVolume& volume = list[1]->volume;
  EXPECT_EQ(volume.blendSlot, "@blend");
  const auto blend = [&](const SlotWords& words) {
    return valueOfWord(words, volume.blendSlot, kVolumeBlends, volume.blend);
  };
  EXPECT_EQ(blend({{"@blend", "minimum"}}), scene::VolumeBlend::minimum);
  EXPECT_EQ(blend({{"@blend", "smallest"}}), scene::VolumeBlend::composite);
  EXPECT_EQ(blend({}), scene::VolumeBlend::composite);
  ASSERT_EQ(list[1]->slotChoices().size(), 1u);
  EXPECT_TRUE(list[1]->slotChoices().at(0).has("average"));
  EXPECT_FALSE(list[1]->slotChoices().at(0).has(""));
  EXPECT_EQ(list[2]->slotChoices().size(), 0u);
  EXPECT_EQ(list[2]->volume.blend, scene::VolumeBlend::additive);
}

}  // namespace
}  // namespace gluray::gl
