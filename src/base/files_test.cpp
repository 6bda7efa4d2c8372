#include "base/files.h"

#include "base/testing/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace gluray::files {
namespace {

namespace fs = std::filesystem;
using test::textOf;

class Files : public testing::Test {
 protected:
  std::string path(const char* name) const { return folder_.file(name); }
  std::string put(const char* name, const std::string& text) const { return folder_.write(name, text); }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_.path())) all.insert(entry.path().filename());
    return all;
  }
  /// Expects that a file of another kind is not replaced, written, appended to, waited for or removed.
  void isLeftAlone(const char* name, const std::string& why) {
    SCOPED_TRACE(name);
    struct stat before {
    }, after{};
    ASSERT_EQ(lstat(path(name).c_str(), &before), 0);
    EXPECT_EQ(replace(path(name), "new"), why);
    EXPECT_EQ(start(path(name)).why, why);
    EXPECT_EQ(append(path(name)).why, why);
    EXPECT_EQ(obstacle(path(name)), why);
    EXPECT_FALSE(claim(path(name)));
    removeOld(path(name));
    ASSERT_EQ(lstat(path(name).c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino);
    EXPECT_EQ(after.st_mode, before.st_mode);
  }

  const test::TemporaryFolder folder_;
};

TEST_F(Files, WholeFilesAreReplaced) {
  EXPECT_EQ(replace(path("a"), "first"), "");
  EXPECT_EQ(textOf(path("a")), "first");
  EXPECT_EQ(replace(path("a"), "second"), "");
  EXPECT_EQ(textOf(path("a")), "second");
  EXPECT_EQ(names(), std::set<std::string>{"a"});
}

TEST_F(Files, DraftsTakeThePlaceOfFilesWhenComplete) {
  put("a", "old");
  {
    Draft draft(path("a"));
    EXPECT_TRUE(draft.write("one, ")) << draft.why();
    EXPECT_TRUE(draft.write("two"));
    EXPECT_EQ(textOf(path("a")), "old");
    EXPECT_EQ(names().size(), 2u) << "the file and its draft";
    EXPECT_TRUE(draft.place()) << draft.why();
  }
  EXPECT_EQ(textOf(path("a")), "one, two");
  EXPECT_TRUE(Draft(path("a")).write("gone"));
  EXPECT_EQ(textOf(path("a")), "one, two");
  EXPECT_EQ(names(), std::set<std::string>{"a"});
  Draft missing(path("no/file"));
  EXPECT_FALSE(missing.write("x"));
  EXPECT_FALSE(missing.place());
  EXPECT_EQ(missing.error(), ENOENT);
  EXPECT_EQ(missing.why(), "No such file or directory");
  EXPECT_EQ(Draft("/dev/null").why(), "it is not a regular file");
}

TEST_F(Files, DraftsAreWrittenInAnyOrder) {
  Draft draft(path("a"));
  EXPECT_TRUE(draft.writeAt(4, "last"));
  EXPECT_TRUE(draft.writeAt(0, "head"));
  EXPECT_TRUE(draft.writeAt(2, "11"));
  EXPECT_TRUE(draft.writeAt(8, ""));
  EXPECT_TRUE(draft.place()) << draft.why();
  EXPECT_EQ(textOf(path("a")), "he11last");
  EXPECT_FALSE(Draft(path("no/file")).writeAt(0, "x"));
}

TEST_F(Files, FilesInTheWorkingDirectoryNeedNoFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  EXPECT_EQ(replace("a", "text"), "");
  fs::current_path(before);
  EXPECT_EQ(textOf(path("a")), "text");
}

TEST_F(Files, HardLinksKeepTheOldContent) {
  put("a", "old");
  fs::create_hard_link(path("a"), path("b"));
  EXPECT_EQ(replace(path("a"), "new"), "");
  EXPECT_EQ(textOf(path("b")), "old");
}

TEST_F(Files, PermissionsStay) {
  put("a", "old");
  chmod(path("a").c_str(), 0600);
  EXPECT_EQ(replace(path("a"), "new"), "");
  struct stat status {};
  ASSERT_EQ(stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(Files, OnlyRegularFilesAreReplaced) {
  fs::create_directory(path("folder"));
  isLeftAlone("folder", "Is a directory");
  mkfifo(path("fifo").c_str(), 0666);
  isLeftAlone("fifo", "it is a FIFO, not a regular file");
  mknod(path("socket").c_str(), S_IFSOCK | 0666, 0);
  isLeftAlone("socket", "it is a socket, not a regular file");
  fs::create_symlink("/dev/full", path("link"));
  isLeftAlone("link", "it is a symbolic link, not a regular file");
}

TEST_F(Files, LinksAreNotFollowed) {
  const std::string victim = put("victim", "precious");
  fs::create_symlink(victim, path("link"));
  fs::create_symlink(path("nowhere"), path("dangling"));
  isLeftAlone("link", "it is a symbolic link, not a regular file");
  isLeftAlone("dangling", "it is a symbolic link, not a regular file");
  EXPECT_EQ(textOf(victim), "precious");
  EXPECT_FALSE(fs::exists(path("nowhere")));
}

TEST_F(Files, NamesOfDraftsCannotBePlanted) {
  const std::string victim = put("victim", "precious");
  for (const char* planted : {"a.new", "a.tmp", "a~"}) fs::create_symlink(victim, path(planted));
  EXPECT_EQ(replace(path("a"), "text"), "");
  EXPECT_EQ(textOf(victim), "precious");
}

TEST_F(Files, FailedWritesLeaveNoFile) {
  EXPECT_EQ(replace(path("none") + "/a", "text"), "No such file or directory");
  EXPECT_EQ(replace("/proc/nowhere/a", "text"), "No such file or directory");
  EXPECT_EQ(replace(put("file", "") + "/a", "text"), "Not a directory");
  EXPECT_EQ(replace(folder_.path().string() + "/", "text"), "Is a directory");
  EXPECT_EQ(names(), std::set<std::string>{"file"});
}

TEST_F(Files, StartedFilesExistAtOnce) {
  put("a", "old");
  const Opened opened = start(path("a"));
  ASSERT_TRUE(opened.isOpen());
  EXPECT_EQ(textOf(path("a")), "");
  EXPECT_TRUE(writeAll(opened.output.descriptor, "more"));
  EXPECT_EQ(textOf(path("a")), "more");
  ::close(opened.output.descriptor);
}

TEST_F(Files, AppendingKeepsTheContent) {
  put("a", "old ");
  for (const char* name : {"a", "b"}) {
    const Opened opened = append(path(name));
    ASSERT_TRUE(opened.isOpen());
    EXPECT_TRUE(writeAll(opened.output.descriptor, "new"));
    ::close(opened.output.descriptor);
  }
  EXPECT_EQ(textOf(path("a")), "old new");
  EXPECT_EQ(textOf(path("b")), "new");
}

TEST_F(Files, StreamsAreNotFiles) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  put("-", "a file of that name");
  ownStreams();
  EXPECT_EQ(start("-").output.descriptor, STDOUT_FILENO);
  removeOld("-");
  EXPECT_EQ(textOf(path("-")), "a file of that name");
  fs::current_path(before);
  for (const char* name : {"-", "/dev/stdout", "/dev/stderr", "/dev/null"}) {
    EXPECT_TRUE(isStream(name)) << name;
    EXPECT_EQ(obstacle(name), "") << name;
  }
  EXPECT_TRUE(isOutput("-"));
  EXPECT_FALSE(isOutput("/dev/stderr"));
  EXPECT_FALSE(isStream("/dev/full"));
  EXPECT_FALSE(isStream("a"));
  EXPECT_EQ(replace("/dev/null", "text"), "");
  testing::internal::CaptureStdout();
  EXPECT_EQ(replace("-", "text"), "the program has closed it");  // the descriptor refers to another file
  ownStreams();
  EXPECT_EQ(replace("-", "text"), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "text");
  ownStreams();
  EXPECT_EQ(append("/dev/stderr").output.descriptor, STDERR_FILENO);
}

TEST_F(Files, DevicesAreRefused) {
  struct stat before {
  }, after{};
  ASSERT_EQ(stat("/dev/full", &before), 0);
  EXPECT_EQ(replace("/dev/full", "text"), "it is a device, not a regular file");
  removeOld("/dev/full");
  ASSERT_EQ(stat("/dev/full", &after), 0);
  EXPECT_EQ(after.st_ino, before.st_ino);
  EXPECT_EQ(read("/dev/zero", 100).why, "it is a device, not a regular file");
  EXPECT_EQ(read("/dev/null", 100).why, "it is a device, not a regular file");
}

TEST_F(Files, OnlyRegularFilesAreRead) {
  mkfifo(path("fifo").c_str(), 0666);
  EXPECT_EQ(read(path("fifo"), 100).why, "it is a FIFO, not a regular file");  // does not block
  EXPECT_EQ(read(folder_.path(), 100).why, "Is a directory");
  const Content none = read(path("none"), 100);
  EXPECT_TRUE(none.missing);
  EXPECT_EQ(none.why, "No such file or directory");
  fs::create_symlink(put("a", "text"), path("link"));
  EXPECT_EQ(read(path("link"), 100).text, "text");
  EXPECT_EQ(read(path("link"), 4).text, "text");
  EXPECT_EQ(read(path("link"), 3).why, "it is larger than 3 bytes");
  EXPECT_FALSE(read(path("fifo"), 100).missing);
}

}  // namespace
}  // namespace gluray::files
