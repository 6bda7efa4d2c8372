// When frames take new settings.
#include "gl/clock/frame_settings.h"

#include "settings/live/settings_source.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

SettingsSource g_source;
int g_spp = 1;

/// Changes settings as LiveSettings does when a file has changed.
void look() noexcept {
  if (g_source.current()->spp == g_spp) return;
  Settings next;
  next.spp = g_spp;
  g_source.store(next);
}

TEST(FrameSettings, FramesLookForChangesWhenTheyBegin) {
  ContextInfo info;
  info.source = &g_source;
  FrameSettings settings(info);
  g_source.watch(look);
  settings.takeCurrent();
  EXPECT_FALSE(settings.takeCurrent()) << "nothing has changed";
  g_spp = 4;
  EXPECT_EQ(settings.now().spp, 1) << "a frame keeps its settings";
  EXPECT_TRUE(settings.takeCurrent());
  EXPECT_EQ(settings.now().spp, 4);
}

}  // namespace
}  // namespace gluray::gl
