// Conversions of every type of setting from and to text, and error messages.
#include "settings/values.h"

#include "settings/value_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray {
namespace {

constexpr Word kWords[] = {{"auto", ""}, {"on", ""}, {"off", ""}};

Row rowOf(Type type, double least = 0, double most = 0) {
  Row row{};
  row.type = type, row.ranged = least < most, row.least = least, row.most = most;
  if (type == Type::choice) row.words = kWords;
  row.files = type == Type::path;
  return row;
}

/// Parses `text`, expects it to print as `printed`, and expects the same value when that is parsed.
template <class T>
void expectRoundTrip(const Row& row, std::string_view text, const T& value, std::string_view printed) {
  T read{}, again{};
  EXPECT_EQ(readText(row, text, read), "") << text;
  EXPECT_TRUE(read == value) << text;
  EXPECT_EQ(printText(row, read), printed);
  EXPECT_EQ(readText(row, printed, again), "") << printed;
  EXPECT_TRUE(again == value) << printed;
}

/// Expects that a wrong value leaves the setting unchanged and that the message names the allowed values.
template <class T>
void expectRefused(const Row& row, std::initializer_list<std::string_view> texts, const T& before,
                   const std::string& why) {
  for (const std::string_view text : texts) {
    T value = before;
    EXPECT_EQ(readText(row, text, value), why) << text;
    EXPECT_TRUE(value == before) << text;
  }
}

TEST(Values, Switches) {
  const Row row = rowOf(Type::boolean);
  expectRoundTrip(row, "1", true, "true");
  expectRoundTrip(row, "false", false, "false");
  expectRoundTrip(row, "on", true, "true");
  expectRoundTrip(row, "off", false, "false");
  expectRefused(row, {"", "yes", "2", "True"}, true, "use on, off, true, false, 1 or 0");
}

TEST(Values, WholeNumbers) {
  Row row = rowOf(Type::integer, 1, 64);
  row.leastMeans = "the centre";
  expectRoundTrip(row, "64", 64, "64");
  expectRefused(row, {"", "0", "65", "1.5", "4x", " 4", "99999999999999999999"}, 7,
                "use a number from 1 (the centre) to 64");
}

TEST(Values, Numbers) {
  Row row = rowOf(Type::real, 0.1, 1e6);
  row.unit = "ms";
  expectRoundTrip(row, "0.1", 0.1f, "0.1");
  expectRoundTrip(row, "2.5e3", 2500.0f, "2500");
  expectRoundTrip(row, "0.30000000001", 0.3f, "0.3");
  expectRefused(row, {"", "0", "-1", "nan", "inf", "1,5", "2e6"}, 7.0f, "use a number from 0.1 to 1e+06 ms");
}

TEST(Values, Choices) {
  const Row row = rowOf(Type::choice);
  expectRoundTrip(row, "off", uint8_t{2}, "off");
  expectRefused(row, {"", "AUTO", "of"}, uint8_t{1}, "use auto, on or off");
}

TEST(Values, Colors) {
  const Row row = rowOf(Type::color, 0, 1);
  expectRoundTrip(row, "#ff8000", glm::vec3{1, 128.0f / 255, 0}, "#ff8000");
  expectRoundTrip(row, "1, 0.25,0", glm::vec3{1, 0.25f, 0}, "1,0.25,0");
  expectRoundTrip(row, "0,0,1", glm::vec3{0, 0, 1}, "#0000ff");
  expectRefused(row, {"", "red", "#ff80", "#ff80zz", "#-1-1-1", "1,1", "1,1,1,1", "1,1,2", "1,,1"},
                glm::vec3{1, 1, 0}, "use #rrggbb, or three numbers from 0 to 1 with commas between them");
}

TEST(Values, ColorsBeyondOne) {
  const Row row = rowOf(Type::color, 0, 100);
  expectRoundTrip(row, "20,0.5,0", glm::vec3{20, 0.5f, 0}, "20,0.5,0");
}

TEST(Values, Vectors) {
  const Row row = rowOf(Type::vector);
  expectRoundTrip(row, "0,-1.5, 3e9", glm::vec3{0, -1.5f, 3e9f}, "0,-1.5,3e+09");
  expectRefused(row, {"", "1,2", "1,2,x", "1,2,inf"}, glm::vec3{1, 2, 3},
                "use three numbers with commas between them");
}

TEST(Values, Texts) {
  expectRoundTrip(rowOf(Type::text), "a = b, c", std::string("a = b, c"), "a = b, c");
  expectRoundTrip(rowOf(Type::path), "", std::string(), "");
}

TEST(Values, Lists) {
  using List = std::vector<std::string>;
  Row row = rowOf(Type::list);
  expectRoundTrip(row, "a,b c,,d:e", List{"a", "b c", "d:e"}, "a,b c,d:e");
  row.files = true;
  expectRoundTrip(row, "/a,1:/b:", List{"/a,1", "/b"}, "/a,1:/b");
  expectRoundTrip(row, "", List{}, "");
}

TEST(Values, QuirksArePrintedWhereTheyDifferFromTheDefault) {
  const Row& row = *findSetting("quirks");
  Session session;
  EXPECT_EQ(printValue(row, session), "");
  const std::string text = "material-latch=off,hide-persistent-mapping=on";
  EXPECT_EQ(readValue(row, "fog-sum=on," + text, session), "");
  EXPECT_EQ(printValue(row, session), text);
}

TEST(Values, EverySettingReadsWhatItPrints) {
  for (const Row& row : settingRows()) {
    Session session;
    EXPECT_EQ(readValue(row, printValue(row, session), session), "") << row.name;
    EXPECT_EQ(session, Session{}) << row.name;
  }
}

TEST(Values, SettingsOfContextsStayBetweenFrames) {
  Settings old, next;
  next.threads = 3, next.spp = 4, next.renderer = Renderer::null, next.bvh = BvhQuality::full;
  keepBetweenFrames(next, old);
  EXPECT_EQ(next.threads, old.threads);
  EXPECT_EQ(next.renderer, old.renderer);
  EXPECT_EQ(next.spp, 4);
  EXPECT_EQ(next.bvh, BvhQuality::full);
}

TEST(Values, OnlySomeSettingsChangeTheImage) {
  Settings settings;
  settings.shading = ShadingRate::vertex, settings.bvh = BvhQuality::least, settings.threads = 1;
  EXPECT_FALSE(settings.changesImage());
  settings.spp = 2;
  EXPECT_TRUE(settings.changesImage());
}

}  // namespace
}  // namespace gluray
