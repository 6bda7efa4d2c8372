// Steps of live changes: undo, redo, and continuation by gestures.
#include "settings/live/settings_history.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

namespace gluray {
namespace {

using Changes = LiveSettings::Changes;

/// A history together with the live values that it changes.
struct SettingsHistoryTest : testing::Test {
  Changes make(const Changes& changes) {
    Changes before;
    for (const auto& c : changes) {
      const auto known = live.find(c.name);
      before.push_back({c.name, known == live.end() ? std::nullopt : std::optional(known->second)});
      if (known != live.end()) live.erase(known);
      if (c.value) live[c.name] = *c.value;
    }
    return before;
  }
  void set(const Changes& changes, const std::string& gesture = "") {
    history.add(changes, make(changes), gesture);
  }
  void undo() { make(history.undoing()), history.undone(); }
  void redo() { make(history.redoing()), history.redone(); }

  std::map<std::string, std::string> live;
  SettingsHistory history;
};
using Live = std::map<std::string, std::string>;

TEST_F(SettingsHistoryTest, StepsAreTakenBackAndMadeAgain) {
  set({{"a", "1"}, {"b", "2"}}), set({{"a", "3"}}), set({{"b", {}}});
  EXPECT_EQ(history.undoSteps(), 3u);
  undo();
  EXPECT_EQ(live, (Live{{"a", "3"}, {"b", "2"}}));
  undo();
  EXPECT_EQ(live, (Live{{"a", "1"}, {"b", "2"}}));
  undo();
  EXPECT_EQ(live, Live{});
  EXPECT_EQ(history.undoSteps(), 0u);
  redo(), redo(), redo();
  EXPECT_EQ(live, (Live{{"a", "3"}}));
  EXPECT_EQ(history.redoSteps(), 0u);
}

TEST_F(SettingsHistoryTest, NewStepsReplaceThoseTakenBack) {
  set({{"a", "1"}}), set({{"a", "2"}});
  undo(), set({{"a", "5"}});
  EXPECT_EQ(history.undoSteps(), 2u);
  EXPECT_EQ(history.redoSteps(), 0u);
  undo();
  EXPECT_EQ(live, (Live{{"a", "1"}}));
}

TEST_F(SettingsHistoryTest, GesturesAreOneStep) {
  set({{"a", "0"}});
  for (const char* value : {"1", "2", "3"}) set({{"a", value}}, "drag 1");
  set({{"b", "1"}}, "drag 1");
  set({{"a", "4"}}, "drag 2");
  EXPECT_EQ(history.undoSteps(), 3u);
  undo();
  EXPECT_EQ(live, (Live{{"a", "3"}, {"b", "1"}}));
  undo();
  EXPECT_EQ(live, (Live{{"a", "0"}}));
  redo();
  EXPECT_EQ(live, (Live{{"a", "3"}, {"b", "1"}}));
}

TEST_F(SettingsHistoryTest, GesturesDoNotContinueAfterUndo) {
  set({{"a", "1"}}, "drag"), set({{"a", "2"}}, "drag");
  undo(), redo();
  set({{"a", "3"}}, "drag");
  EXPECT_EQ(history.undoSteps(), 2u);
  undo();
  EXPECT_EQ(live, (Live{{"a", "2"}}));
}

TEST_F(SettingsHistoryTest, WhatChangesNothingIsNoStep) {
  set({}), set({{"a", {}}});
  EXPECT_EQ(history.undoSteps(), 0u);
  set({{"a", "1"}}), set({{"a", "1"}});
  EXPECT_EQ(history.undoSteps(), 1u);
}

TEST_F(SettingsHistoryTest, GesturesThatEndWhereTheyBeganAreNoStep) {
  set({{"spp", "2"}});
  set({{"engine", "never"}}, "compare");
  EXPECT_EQ(history.undoSteps(), 2u);
  set({{"engine", std::nullopt}}, "compare");
  EXPECT_EQ(history.undoSteps(), 1u);
  set({{"engine", "always"}}, "compare");
  EXPECT_EQ(history.undoSteps(), 2u) << "the gesture goes on";
  undo();
  EXPECT_EQ(history.undoSteps(), 1u);
}

TEST_F(SettingsHistoryTest, TheLastHundredStepsAreKept) {
  for (int i = 0; i < 250; ++i) set({{"a", std::to_string(i)}});
  EXPECT_EQ(history.undoSteps(), SettingsHistory::kMaxSteps);
  while (history.undoSteps()) undo();
  EXPECT_EQ(live, (Live{{"a", "149"}}));
  EXPECT_EQ(history.redoSteps(), SettingsHistory::kMaxSteps);
}

}  // namespace
}  // namespace gluray
