#include "model/calls.h"

#include "model/controls.h"

#include <gtest/gtest.h>

#include <memory>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct CallsTest : testing::Test {
  void take(const json& message) { controls.receiveMessage(std::make_shared<const json>(message)); }
  void takePrograms(std::initializer_list<int> numbers) {
    json list = json::array();
    for (const int n : numbers) list.push_back({{"program", n}, {"pid", 100 + n}, {"name", "p"}});
    take({{"type", "event"}, {"what", "programs"}, {"programs", list}});
  }
  void call() {
    controls.call(1, "pick", {{"x", 3}}, receiver.get(),
                  [this](const CallAnswer& answer) { answers.push_back(answer); });
  }
  void answer(json message) {
    message["type"] = "answer";
    message["id"] = sent.back()["id"];
    take(message);
  }

  std::vector<json> sent;
  Controls controls{[this](json message) { sent.push_back(std::move(message)); }};
  std::unique_ptr<QObject> receiver = std::make_unique<QObject>();
  std::vector<CallAnswer> answers;
};

TEST_F(CallsTest, TheAnswerGoesToWhoAsked) {
  takePrograms({1});
  call();
  EXPECT_EQ(sent.back()["type"], "call");
  EXPECT_EQ(sent.back()["program"], 1);
  EXPECT_EQ(sent.back()["name"], "pick");
  EXPECT_EQ(sent.back()["arguments"], json({{"x", 3}}));
  EXPECT_TRUE(answers.empty());
  const json wanted{{"results", {{{"program", 1}, {"value", {{"object", 4}}}}}}};
  answer(wanted);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].value, json({{"object", 4}}));
  EXPECT_EQ(answers[0].why, "");
  answer(wanted);
  EXPECT_EQ(answers.size(), 1u) << "a second answer is nobody's";
}

TEST_F(CallsTest, FailuresSayWhy) {
  takePrograms({1});
  for (const json& message :
       {json{{"why", "too many"}}, json{{"results", {{{"program", 1}, {"why", "too many"}}}}}}) {
    call();
    answer(message);
    EXPECT_EQ(answers.back().why, "too many");
    EXPECT_TRUE(answers.back().value.is_null());
  }
  for (const json& message : {json::object(), json{{"results", 7}}, json{{"results", json::array()}},
                              json{{"results", {1}}}, json{{"why", 3}, {"results", {nullptr}}}}) {
    call();
    answer(message);
    EXPECT_FALSE(answers.back().why.empty()) << message;
  }
}

TEST_F(CallsTest, AProgramThatEndsAnswersNothingMore) {
  takePrograms({1, 2});
  call();
  const json late = sent.back()["id"];
  takePrograms({2});
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].why, "the program has ended");
  take({{"type", "answer"}, {"id", late}, {"results", {{{"program", 1}, {"value", 5}}}}});
  EXPECT_EQ(answers.size(), 1u);
}

TEST_F(CallsTest, NobodyIsCalledAfterTheReceiverHasGone) {
  takePrograms({1});
  call();
  receiver.reset();
  answer({{"results", {{{"program", 1}, {"value", 5}}}}});
  call();
  controls.disconnected("it ended");
  EXPECT_TRUE(answers.empty());
}

TEST_F(CallsTest, ABatchIsOneRequest) {
  takePrograms({1});
  std::vector<CallAnswer> all;
  controls.batch(1, {{{"type", "set"}, {"values", {{"ao", true}}}}, {{"type", "call"}, {"name", "shot"}}},
                 receiver.get(), [&](const std::vector<CallAnswer>& parts) { all = parts; });
  EXPECT_EQ(sent.back()["type"], "batch");
  ASSERT_EQ(sent.back()["requests"].size(), 2u);
  EXPECT_EQ(sent.back()["requests"][1]["program"], 1);
  answer({{"answers",
           {{{"results", {{{"program", 1}, {"frame", 7}}}}},
            {{"results", {{{"program", 1}, {"why", "it draws nothing"}}}}},
            3}}});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].value["frame"], 7);
  EXPECT_EQ(all[1].why, "it draws nothing");
  EXPECT_FALSE(all[2].why.empty());
}

TEST_F(CallsTest, TheLargestWishForThumbnailsCounts) {
  controls.connected();
  EXPECT_FALSE(sent.front().contains("size"));
  const QObject other;
  controls.wantThumbnails(receiver.get(), 400);
  controls.wantThumbnails(&other, 300);
  EXPECT_EQ(sent.back()["type"], "observe");
  EXPECT_EQ(sent.back()["size"], 400);
  controls.wantThumbnails(receiver.get(), 0);
  EXPECT_EQ(sent.back()["size"], 300);
}

}  // namespace
}  // namespace gluray::panel
