// The runtime directory, and files that may be planted in its place.
#include "control/runtime_directory.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace gluray::control {
namespace {

namespace fs = std::filesystem;

class RuntimeDirectory : public testing::Test {
 protected:
  RuntimeDirectory()
      : folder_(fs::path(testing::TempDir()) / ("gluray-runtime-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~RuntimeDirectory() override { fs::remove_all(folder_); }
  std::string path() const { return folder_ / "gluray"; }
  fs::path folder_;
};

TEST_F(RuntimeDirectory, IsMadeOnceAndUsedAgain) {
  EXPECT_NE(whyUnsafe(path()), "") << "there is none";
  const mode_t before = umask(0);
  EXPECT_EQ(makeRuntimeDirectory(path()), "");
  umask(before);
  EXPECT_EQ(makeRuntimeDirectory(path()), "");
  EXPECT_EQ(whyUnsafe(path()), "");
  chmod(path().c_str(), 02700);  // as below directories that pass on their group
  EXPECT_EQ(whyUnsafe(path()), "");
  chmod(path().c_str(), 0700);
  EXPECT_EQ(fs::status(path()).permissions(), fs::perms::owner_all);
}

TEST_F(RuntimeDirectory, OthersMayNeitherReadNorWriteNorOwnIt) {
  makeRuntimeDirectory(path());
  for (const mode_t mode : {0701, 0710, 0777, 0500}) {
    chmod(path().c_str(), mode);
    EXPECT_NE(whyUnsafe(path()), "") << std::oct << mode;
  }
  chmod(path().c_str(), 0700);
  constexpr uid_t kNobody = 65534;
  if (chown(path().c_str(), kNobody, getegid()) != 0) GTEST_SKIP() << "only root gives directories away";
  EXPECT_NE(makeRuntimeDirectory(path()).find("another user"), std::string::npos);
}

TEST_F(RuntimeDirectory, LinksAndFilesInItsPlaceAreRefused) {
  fs::create_directories(folder_ / "other");
  chmod((folder_ / "other").c_str(), 0700);
  fs::create_directory_symlink(folder_ / "other", path());
  EXPECT_NE(makeRuntimeDirectory(path()).find("symbolic link"), std::string::npos);
  fs::remove(path());
  std::ofstream(path()) << "x";
  EXPECT_NE(makeRuntimeDirectory(path()).find("not a directory"), std::string::npos);
  EXPECT_NE(makeRuntimeDirectory(folder_ / "none" / "gluray"), "");
}

/// Restores a variable at the end of its lifetime.
struct Kept {
  const char* name;
  std::string before = std::getenv(name) ? std::getenv(name) : "";
  bool was = std::getenv(name) != nullptr;
  ~Kept() { was ? setenv(name, before.c_str(), 1) : unsetenv(name); }
};

TEST_F(RuntimeDirectory, IsNamedByVariables) {
  const Kept runtime{"GLURAY_RUNTIME"}, session{"XDG_RUNTIME_DIR"};
  setenv("GLURAY_RUNTIME", "/a", 1), setenv("XDG_RUNTIME_DIR", "/b", 1);
  EXPECT_EQ(runtimeDirectory(), "/a");
  setenv("GLURAY_RUNTIME", "/a/link//", 1);
  EXPECT_EQ(runtimeDirectory(), "/a/link") << "lstat follows links before a slash";
  setenv("GLURAY_RUNTIME", "a", 1);
  EXPECT_NE(makeRuntimeDirectory(runtimeDirectory()), "");
  unsetenv("GLURAY_RUNTIME");
  EXPECT_EQ(runtimeDirectory(), "/b/gluray");
  unsetenv("XDG_RUNTIME_DIR");
  EXPECT_EQ(runtimeDirectory(), "/tmp/gluray-" + std::to_string(getuid()));
}

}  // namespace
}  // namespace gluray::control
