#include "settings/settings_source.h"

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

}  // namespace
}  // namespace gluray
