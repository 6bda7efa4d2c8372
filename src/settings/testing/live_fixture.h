// Live settings that read files in a temporary folder, for tests.
#pragma once
#include "settings/live/live_settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace gluray::test {

using Changes = std::vector<LiveSettings::Change>;

class Live : public testing::Test {
 protected:
  Live() : folder_(testing::TempDir() + "gluray-live-" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
    sources_.userFile = (folder_ / "user.toml").string();
    sources_.projectFile = (folder_ / "gluray.toml").string();
    sources_.variables.emplace();
  }
  ~Live() override { std::filesystem::remove_all(folder_); }

  static void write(const std::string& file, const std::string& text) {
    std::ofstream(file) << text;
    chmod(file.c_str(), 0644);
  }
  /// Checks the files after they have been unchanged for long enough to be read.
  void readWhenRested() {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    live_.readIfChanged(now_ += 100);
  }
  int spp() const { return source_.current()->spp; }
  std::string whyOf(const Changes& changes) { return live_.change(changes).why; }

  std::filesystem::path folder_;
  double now_ = 1000;
  Sources sources_;
  SettingsSource source_;
  std::vector<std::string> complaints_;
  LiveSettings live_{source_, [this](const std::string& line) { complaints_.push_back(line); }};
};

}  // namespace gluray::test
