// Files of lights for the tests of render/.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace gluray::test {

/// A file of lights; removed when it goes.
class LightFile {
 public:
  explicit LightFile(const std::string& text) { write(text); }
  LightFile(const LightFile&) = delete;
  LightFile& operator=(const LightFile&) = delete;
  ~LightFile() { std::remove(name.c_str()); }
  void write(const std::string& text) const { std::ofstream(name) << text; }
  const std::string name = ::testing::TempDir() + "gluray_lights_" + std::to_string(getpid()) + "_" +
                           std::to_string(reinterpret_cast<uintptr_t>(this)) + ".toml";
};

}  // namespace gluray::test
