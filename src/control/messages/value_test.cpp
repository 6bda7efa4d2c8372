#include "control/messages/value.h"

#include "settings/named_row.h"
#include "settings/values.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gluray::control {
namespace {

using nlohmann::json;

TEST(ValueOf, HasTheSettingsType) {
  EXPECT_EQ(valueOf(namedRow("ao"), "true"), json(true));
  EXPECT_EQ(valueOf(namedRow("ao.samples"), "16"), json(16));
  EXPECT_EQ(valueOf(namedRow("bvh"), "fast"), json("fast"));
}

TEST(ValueOf, OfEverySettingIsReadAgainAsTheSameValue) {
  for (const Row& one : settingRows()) {
    const std::string text = printValue(one, Session{});
    const TextOrWhy again = textOf(one, valueOf(one, text));
    EXPECT_EQ(again.why, "") << one.name;
    Session session;
    if (!again.text.empty()) { EXPECT_EQ(readValue(one, again.text, session), "") << one.name; }
    EXPECT_TRUE(sameValue(one, session, Session{})) << one.name;
  }
}

TEST(TextOf, TakesStringsAsInFiles) {
  EXPECT_EQ(textOf(namedRow("ao"), json("on")).text, "on");
  EXPECT_EQ(textOf(namedRow("ao.samples"), json("16")).text, "16");
  EXPECT_EQ(textOf(namedRow("ao.samples"), json(16)).text, "16");
  EXPECT_EQ(textOf(namedRow("ao"), json(false)).text, "false");
}

TEST(TextOf, JoinsLists) {
  for (const Row& one : settingRows()) {
    if (one.type == Type::vector) {
      EXPECT_EQ(textOf(one, json({1, 2.5, -3})).text, "1,2.5,-3") << one.name;
      EXPECT_EQ(valueOf(one, "1,2.5,-3"), json({1, 2.5, -3})) << one.name;
    }
    if (one.type == Type::list) {
      EXPECT_EQ(valueOf(one, textOf(one, json({"a", "b"})).text), json({"a", "b"})) << one.name;
    }
  }
}

TEST(TextOf, RefusesWhatIsNoValue) {
  for (const json& value :
       {json(), json::object(), json({json::object()}), json({json::array()}), json::array({nullptr})}) {
    const TextOrWhy text = textOf(namedRow("ao"), value);
    EXPECT_EQ(text.text, "") << value;
    EXPECT_EQ(text.why, "ao: use a boolean, a number, a string or a list of these") << value;
  }
}

TEST(Description, HasWhatWidgetsNeed) {
  const json samples = description(namedRow("ao.samples"));
  EXPECT_EQ(samples["title"], "Occlusion rays");
  EXPECT_EQ(samples["group"], "Occlusion");
  EXPECT_EQ(samples["level"], "advanced");
  EXPECT_EQ(samples["unit"], "rays");
  EXPECT_EQ(description(namedRow("ao"))["level"], "basic");
  EXPECT_EQ(samples["type"], "integer");
  EXPECT_EQ(samples["least"], 1);
  EXPECT_TRUE(samples["most"].is_number());
  EXPECT_FALSE(samples["help"].get<std::string>().empty());
  const json bvh = description(namedRow("bvh"));
  EXPECT_EQ(bvh["type"], "choice");
  EXPECT_GT(bvh["words"].size(), 2u);
}

}  // namespace
}  // namespace gluray::control
