#include "control/scene/object_words.h"

#include <gtest/gtest.h>

namespace gluray::launcher {
namespace {

using Words = std::vector<std::string>;
using Objects = std::vector<uint32_t>;

TEST(ObjectWords, ObjectsStandInFront) {
  Words words{"3", "5-7", "glass", "roughness=0.1"};
  ObjectChoice choice;
  EXPECT_EQ(takeObjects(words, choice), "");
  EXPECT_EQ(words, (Words{"glass", "roughness=0.1"}));
  EXPECT_TRUE(choice.has(3) && choice.has(5) && choice.has(7));
  EXPECT_FALSE(choice.has(4) || choice.has(8) || choice.all);

  Words all{"all"};
  ObjectChoice everything;
  EXPECT_EQ(takeObjects(all, everything), "");
  EXPECT_TRUE(all.empty() && everything.has(12345) && !everything.empty());

  Words none{"glass"};
  ObjectChoice nothing;
  EXPECT_EQ(takeObjects(none, nothing), "");
  EXPECT_TRUE(nothing.empty() && !nothing.has(1));
  EXPECT_EQ(none, Words{"glass"});
}

TEST(ObjectWords, WrongNumbersAreRefused) {
  for (const char* word : {"0", "3-", "7-5", "3-x", "3.5", "99999999999", "0-4", "3-4-5"}) {
    Words words{word};
    ObjectChoice choice;
    EXPECT_EQ(takeObjects(words, choice),
              std::string(word) + ": objects are numbers from 1, such as 3, or ranges, such as 5-7");
  }
}

TEST(ObjectWords, RangesChooseThoseThatExist) {
  uint32_t missing = 0;
  ObjectChoice choice{{{2, 5}, {4, 4}}};
  EXPECT_EQ(chosenObjects(choice, {1, 4, 5, 9}, missing), (Objects{4, 5}));
  EXPECT_EQ(missing, 0u);
  choice.ranges.emplace_back(7, 7);
  chosenObjects(choice, {1, 4, 5, 9}, missing);
  EXPECT_EQ(missing, 7u);
  EXPECT_EQ(chosenObjects({{}, true}, {1, 9, 9}, missing), (Objects{1, 9}));
}

TEST(ObjectWords, WordsAreChecked) {
  EXPECT_EQ(problemOfWords({"glass", "roughness=0.1", "hidden-from=camera"}), "");
  EXPECT_EQ(problemOfWords({}), "");
  EXPECT_EQ(problemOfWords({"roughness=2"}), "roughness=2: use a number from 0 to 1");
  EXPECT_EQ(problemOfWords({"glass,3"}), "glass,3: use one word a value");
  EXPECT_EQ(problemOfWords({"glass matte"}), "glass matte: use one word a value");
}

}  // namespace
}  // namespace gluray::launcher
