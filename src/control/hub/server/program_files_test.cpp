// Files that programs leave, as a hub reads them at its start.
#include "control/hub/server/program_files.h"

#include "control/testing/server_fixture.h"

#include <sys/stat.h>
#include <sys/wait.h>

#include <fstream>

namespace gluray::control::test {
namespace {

namespace fs = std::filesystem;

TEST_F(HubServerTest, FilesOfProgramsAreReadWithCare) {
  start();
  hub_.stop();
  const fs::path files = fs::path(options_.directory) / "programs";
  fs::create_directory(files);
  const auto content = [](pid_t pid) {
    return json{{"pid", pid}, {"name", "p"}, {"display", ":7"}, {"window", 77}}.dump() + "\n";
  };
  const pid_t gone = fork();
  if (gone == 0) _exit(0);
  waitpid(gone, nullptr, 0);
  const pid_t self = getpid(), parent = getppid();
  std::ofstream(files / std::to_string(self)) << content(self);
  std::ofstream(files / std::to_string(gone)) << content(gone);
  std::ofstream(files / "nonsense") << content(self);
  std::ofstream(folder_ / "elsewhere") << content(parent);
  fs::create_symlink(folder_ / "elsewhere", files / std::to_string(parent));
  std::vector<std::string> woken;
  options_.wake = [&](const std::string& display, unsigned long window) {
    woken.push_back(display + " " + std::to_string(window));
  };
  start();
  EXPECT_EQ(woken, std::vector<std::string>{":7 77"});
  EXPECT_EQ(hub_.expected(), 1u);
  const json hello = nextMessage(connectHere());
  EXPECT_EQ(hello.value("expected", 0), 1);
  EXPECT_GE(hello.value("age", -1.0), 0);
  EXPECT_LT(hello.value("age", 60.0), 60);
  EXPECT_EQ(hub_.clients(), 1u) << "it may become one";
  EXPECT_FALSE(fs::exists(files / std::to_string(gone)));
  for (int i = 0; i < 500 && woken.size() < 2; ++i) io_.run_one_for(std::chrono::milliseconds(20));
  EXPECT_EQ(woken, std::vector<std::string>(2, ":7 77")) << "again, while it is not connected";
  for (const std::string& wrong :
       {content(self + 1), std::string("[["), content(self) + std::string(5000, ' '), std::string(),
        std::string("7"),
        std::string(R"({"pid": )") + std::to_string(self) + R"(, "display": ":7", "window": -1})"}) {
    std::ofstream(files / std::to_string(self)) << wrong;
    EXPECT_EQ(hub_.expected(), 0u) << wrong;
  }
  std::ofstream(files / std::to_string(self)) << json{{"pid", self}, {"display", ""}, {"window", 0}}.dump();
  EXPECT_EQ(hub_.expected(), 1u) << "without a window";
  const size_t before = woken.size();
  hub_.stop();
  start();
  EXPECT_EQ(woken.size(), before) << "there is none to wake";
  json dated = json::parse(content(self));
  std::ifstream stat("/proc/self/stat");
  std::string word;
  while (word.find(')') == word.npos) stat >> word;
  for (int field = 3; field <= 22; ++field) stat >> word;
  dated["since"] = std::stoll(word);
  std::ofstream(files / std::to_string(self)) << dated.dump();
  EXPECT_EQ(hub_.expected(), 1u);
  dated["since"] = std::stoll(word) + 1;
  std::ofstream(files / std::to_string(self)) << dated.dump();
  EXPECT_EQ(hub_.expected(), 0u) << "another process had this number";
  EXPECT_FALSE(fs::exists(files / std::to_string(self)));
  ASSERT_EQ(mkfifo((files / std::to_string(self)).c_str(), 0600), 0);
  EXPECT_EQ(hub_.expected(), 0u) << "and it does not wait for a writer";
}

}  // namespace
}  // namespace gluray::control::test
