#include "control/link/registration.h"

#include "base/files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace gluray::control {
namespace {

namespace fs = std::filesystem;

struct RegistrationTest : testing::Test {
  RegistrationTest()
      : folder(fs::path(testing::TempDir()) / ("gluray-registration-" + std::to_string(getpid()))) {
    fs::create_directories(folder);
  }
  ~RegistrationTest() override { fs::remove_all(folder); }
  std::string leave() const { return leaveRegistration(directory(), {"view\xff", ":7", 4194311}); }
  std::string directory() const { return folder / "gluray"; }
  fs::path folder;
};

TEST_F(RegistrationTest, IsOneLineInADirectoryOfTheUser) {
  EXPECT_EQ(leave(), "");
  EXPECT_EQ(leave(), "") << "again";
  const std::string text = files::read(registrationFile(directory()), 1000).text;
  const auto line = nlohmann::json::parse(text);
  EXPECT_EQ(line["pid"], getpid());
  EXPECT_EQ(line["display"], ":7");
  EXPECT_EQ(line["window"], 4194311);
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  for (const char* made : {"", "/programs"})
    EXPECT_EQ(fs::status(directory() + made).permissions(), fs::perms::owner_all);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory() + "/programs"), {}), 1);
}

TEST_F(RegistrationTest, NothingIsWrittenWhereOthersMayWrite) {
  fs::create_directories(folder / "other");
  fs::create_directory_symlink(folder / "other", directory());
  EXPECT_NE(leave(), "");
  fs::remove(directory());
  mkdir(directory().c_str(), 0700), chmod(directory().c_str(), 0755);
  EXPECT_NE(leave(), "");
  chmod(directory().c_str(), 0700);
  fs::create_directory_symlink(folder / "other", directory() + "/programs");
  EXPECT_NE(leave(), "");
  EXPECT_TRUE(fs::is_empty(folder / "other"));
}

}  // namespace
}  // namespace gluray::control
