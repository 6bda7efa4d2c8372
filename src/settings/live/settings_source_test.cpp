#include "settings/live/settings_source.h"

#include <gtest/gtest.h>

#include <thread>

namespace gluray {
namespace {

TEST(SettingsSource, ValuesThatWereTakenDoNotChange) {
  SettingsSource source;
  const auto before = source.current();
  const uint64_t version = source.version();
  Settings next;
  next.spp = 4;
  source.store(next);
  EXPECT_EQ(before->spp, 1);
  EXPECT_EQ(source.current()->spp, 4);
  EXPECT_GT(source.version(), version);
}

TEST(SettingsSource, StoresAndReadsMayOverlap) {
  SettingsSource source;
  std::thread writer([&] {
    for (int i = 1; i <= 1000; ++i) {
      Settings next;
      next.spp = i, next.threads = i;
      source.store(next);
    }
  });
  for (int i = 0; i < 1000; ++i) {
    const auto now = source.current();
    EXPECT_TRUE(now->spp == now->threads || now->threads == 0);
  }
  writer.join();
  EXPECT_EQ(source.current()->spp, 1000);
}

TEST(SettingsSource, FramesBeginWithAClearOrWhenTheOneBeforeIsShown) {
  SettingsSource source;
  EXPECT_EQ(source.frame(), 1u);
  EXPECT_EQ(source.begun().frame, 0u);
  EXPECT_EQ(source.begun().active, 0);
  source.beginFrame(), source.beginFrame();
  EXPECT_EQ(source.begun().frame, 1u);
  const double first = source.begun().began;
  EXPECT_GT(first, 0);
  source.endFrame();
  EXPECT_EQ(source.frame(), 2u);
  EXPECT_EQ(source.begun().frame, 1u);
  const double shown = source.begun().active;
  source.endFrame();
  EXPECT_EQ(source.begun().frame, 2u);
  EXPECT_EQ(source.begun().began, shown) << "frame 2 had no clear";
  EXPECT_EQ(source.begun().before, first);
  EXPECT_EQ(source.frame(), 3u);
}

TEST(SettingsSource, FramesThatTookAVersionAreKnown) {
  SettingsSource source;
  uint64_t version = 0;
  const auto next = [&](uint64_t& of) { source.endFrame(), source.takeNewer(of); };
  EXPECT_FALSE(source.firstFrameWith(1));
  EXPECT_TRUE(source.takeNewer(version));
  EXPECT_FALSE(source.firstFrameWith(1)) << "it has not begun";
  source.beginFrame();
  EXPECT_EQ(source.firstFrameWith(1), 1u);
  source.store({}), source.store({});
  next(version);
  EXPECT_FALSE(source.firstFrameWith(2));
  source.beginFrame();
  EXPECT_EQ(source.firstFrameWith(2), 2u);
  uint64_t other = 0;  // of another context
  next(other), source.beginFrame();
  EXPECT_EQ(source.firstFrameWith(3), 2u);
  EXPECT_FALSE(source.firstFrameWith(4));
}

TEST(SettingsSource, LaterSettingsCountInTheirFrame) {
  SettingsSource source;
  uint64_t version = 0;
  source.takeNewer(version);
  Settings next;
  next.spp = 4;
  const uint64_t ticket = source.storeAt(3, next);
  source.endFrame();
  EXPECT_EQ(source.takeNewer(version), nullptr);
  EXPECT_FALSE(source.counts(ticket));
  Settings both = next;
  both.threads = 2, next.threads = 2, next.spp = 1;
  source.storeBoth(next, both);
  EXPECT_EQ(source.takeNewer(version)->spp, 1);
  source.endFrame();
  EXPECT_EQ(*source.takeNewer(version), both);
  source.beginFrame();
  EXPECT_EQ(source.firstFrameOfTicket(ticket), 3u);
  source.storeBoth(next, both);
  EXPECT_EQ(*source.current(), both) << "nothing waits";
}

}  // namespace
}  // namespace gluray
