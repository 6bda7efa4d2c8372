#include "base/guarded_write.h"

#include "base/files.h"
#include "base/testing/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace gluray {
namespace {

constexpr int kAtOnce = 0;

/// Writes `text`; returns the error.
int written(const GlurayOutput& output, const std::string& text, int patienceMs = kAtOnce) {
  int error = 0;
  const size_t bytes = glurayWrite(&output, text.data(), text.size(), patienceMs, &error);
  EXPECT_EQ(error == 0, bytes == text.size());
  return error;
}

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() { EXPECT_EQ(pipe(ends.data()), 0); }
  ~Pipe() {
    for (const int end : ends)
      if (end >= 0) close(end);
  }
  void fill() const {
    const int flags = fcntl(ends[1], F_GETFL);
    fcntl(ends[1], F_SETFL, flags | O_NONBLOCK);
    const std::string bytes(4096, 'x');
    while (write(ends[1], bytes.data(), bytes.size()) > 0) {}
    fcntl(ends[1], F_SETFL, flags);
  }
};

using test::textOf;

class GuardedWrite : public testing::Test {
 protected:
  std::string path(const char* name) const { return folder_.file(name); }
  const test::TemporaryFolder folder_;
};

TEST_F(GuardedWrite, AnotherFileWithTheSameNumberGetsNothing) {
  Pipe pipe;
  const GlurayOutput output = glurayOutputOf(pipe.ends[1]);
  EXPECT_EQ(written(output, "one"), 0);
  const int file = open(path("data").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(dup2(file, pipe.ends[1]), pipe.ends[1]);
  close(file);
  EXPECT_EQ(written(output, "two"), EBADF);
  EXPECT_EQ(textOf(path("data")), "");
  close(pipe.ends[1]);
  EXPECT_EQ(written(output, "three"), EBADF);
  pipe.ends[1] = -1;
}

TEST_F(GuardedWrite, FullPipesDropTheLine) {
  const Pipe pipe;
  pipe.fill();
  EXPECT_EQ(written(glurayOutputOf(pipe.ends[1]), "a line\n"), EAGAIN);
  EXPECT_EQ(written(glurayOutputOf(pipe.ends[1]), "a line\n", 10), EAGAIN);
  EXPECT_EQ(fcntl(pipe.ends[1], F_GETFL) & O_NONBLOCK, 0);
}

TEST_F(GuardedWrite, FullSocketsDropTheLine) {
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  const std::string bytes(4096, 'x');
  while (send(ends[1], bytes.data(), bytes.size(), MSG_DONTWAIT) > 0) {}
  EXPECT_EQ(written(glurayOutputOf(ends[1]), "a line\n"), EAGAIN);
  close(ends[0]);
  EXPECT_EQ(written(glurayOutputOf(ends[1]), "a line\n"), EPIPE);
  close(ends[1]);
}

TEST_F(GuardedWrite, FullTerminalsDropTheLine) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) GTEST_SKIP() << "no terminals here";
  const int end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  ASSERT_GE(end, 0);
  const GlurayOutput output = glurayOutputOf(end);
  EXPECT_EQ(written(output, "a line\n"), 0);
  int lines = 0;
  while (lines < 100'000 && written(output, std::string(200, 'x') + "\n") == 0) ++lines;
  EXPECT_GT(lines, 10);
  EXPECT_LT(lines, 100'000);
  close(end), close(terminal);
}

TEST_F(GuardedWrite, PipesWithoutReadersSendNoSignal) {
  Pipe pipe;
  close(pipe.ends[0]);
  pipe.ends[0] = -1;
  ASSERT_EQ(signal(SIGPIPE, SIG_DFL), SIG_DFL);
  errno = ENOMEM;
  const int error = written(glurayOutputOf(pipe.ends[1]), "a line\n");
  EXPECT_EQ(errno, ENOMEM);
  EXPECT_EQ(error, EPIPE);
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  EXPECT_FALSE(sigismember(&blocked, SIGPIPE));
}

/// The host's own SIGPIPE, blocked and pending, is not removed.
TEST_F(GuardedWrite, ThePendingSignalOfTheHostStays) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  close(ends[0]);
  sigset_t one, before, pending;
  sigemptyset(&one), sigaddset(&one, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &one, &before);
  pthread_kill(pthread_self(), SIGPIPE);
  EXPECT_EQ(written(glurayOutputOf(ends[1]), "a line\n"), EPIPE);
  sigpending(&pending);
  EXPECT_TRUE(sigismember(&pending, SIGPIPE));
  const timespec now{};
  EXPECT_EQ(sigtimedwait(&one, nullptr, &now), SIGPIPE);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(ends[1]);
}

TEST_F(GuardedWrite, TheLimitOfFileSizesSendsNoSignal) {
  const auto limited = [this] {
    const rlimit limit{4, 4};
    setrlimit(RLIMIT_FSIZE, &limit);
    const int file = open(path("file").c_str(), O_WRONLY | O_CREAT, 0600);
    int error = 0;
    const GlurayOutput output = glurayOutputOf(file);
    glurayWrite(&output, "a line\n", 7, kAtOnce, &error);
    _exit(error == EFBIG ? 42 : 1);
  };
  EXPECT_EXIT(limited(), testing::ExitedWithCode(42), "");
  EXPECT_EQ(textOf(path("file")), "a li");
}

TEST_F(GuardedWrite, FilesThatTheHostClosedAreOpenedAgain) {
  files::Opened mine = files::start(path("mine"));
  std::string text = "one ";
  EXPECT_TRUE(files::write(mine, text, kAtOnce));
  const int number = mine.output.descriptor;
  close(number);
  const int theirs = open(path("theirs").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(theirs, number);
  text = "two";
  EXPECT_TRUE(files::write(mine, text, kAtOnce));
  EXPECT_EQ(text, "");
  EXPECT_EQ(textOf(path("mine")), "one two");
  EXPECT_EQ(textOf(path("theirs")), "");
  close(mine.output.descriptor);
  ASSERT_EQ(dup2(theirs, mine.output.descriptor), mine.output.descriptor);
  const int twin = mine.output.descriptor;
  files::close(mine);
  EXPECT_EQ(fcntl(twin, F_GETFD), 0) << "the host's descriptor was closed";
  close(twin), close(theirs);
}

TEST_F(GuardedWrite, AFileThatWasReplacedIsNotOpenedAgain) {
  files::Opened mine = files::start(path("mine"));
  close(mine.output.descriptor);
  std::filesystem::rename(path("mine"), path("moved"));
  std::ofstream(path("mine")) << "theirs";
  std::string text = "more";
  EXPECT_FALSE(files::write(mine, text, kAtOnce));
  EXPECT_EQ(mine.why, "the program has closed it");
  EXPECT_EQ(textOf(path("mine")), "theirs");
}

TEST_F(GuardedWrite, StreamsAreThoseOfTheLauncher) {
  const Pipe pipe;
  const int saved = dup(STDERR_FILENO);
  dup2(pipe.ends[1], STDERR_FILENO);
  const GlurayOutput of = glurayOutputOf(STDERR_FILENO);
  const auto streamFor = [](const char* identities) {
    identities ? setenv(GLURAY_STREAMS, identities, 1) : unsetenv(GLURAY_STREAMS);
    const GlurayOutput stream = glurayStream(STDERR_FILENO);
    unsetenv(GLURAY_STREAMS);
    return stream;
  };
  std::array<char, 64> right{};
  snprintf(right.data(), right.size(), "- %llx.%llx", of.device, of.inode);
  EXPECT_EQ(written(streamFor(right.data()), "a"), 0);
  EXPECT_EQ(written(streamFor("1.2 3.4"), "b"), EBADF);
  for (const char* closed : {"1.2 -", "", "nonsense", "1.2"})
    EXPECT_EQ(streamFor(closed).descriptor, -1) << closed;
  EXPECT_EQ(written(streamFor(nullptr), "c"), 0);
  const int file = open(path("file").c_str(), O_WRONLY | O_CREAT, 0600);
  dup2(file, STDERR_FILENO);
  EXPECT_EQ(streamFor(nullptr).descriptor, -1) << "a regular file may be the host's";
  dup2(saved, STDERR_FILENO);
  close(saved), close(file);
}

}  // namespace
}  // namespace gluray
