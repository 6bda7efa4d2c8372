#include "intercept/capture/capture_folder.h"

#include "base/files.h"
#include "intercept/session/guarded.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>

namespace gluray::intercept {
namespace {

constexpr int kMostScenes = 3;  // that wait for the launcher
constexpr std::chrono::milliseconds kPause{20};

/// The launcher holds a lock on this file while it draws what comes.
bool isLauncherThere(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool free = ::flock(descriptor, LOCK_SH | LOCK_NB) == 0;
  ::close(descriptor);
  return !free;
}

}  // namespace

bool CaptureFolder::claim() { return files::claim(path_ + "/program"); }

std::string CaptureFolder::fileOf(uint64_t frame, const char* ending) const {
  char name[64];
  std::snprintf(name, sizeof name, "/%012llu.%s", static_cast<unsigned long long>(frame), ending);
  return path_ + name;
}

int CaptureFolder::scenesLeft() const {
  int count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(path_, error))
    count += entry.path().extension() == ".gluray";
  return count;
}

void CaptureFolder::waitForLauncher() const {
  while (scenesLeft() >= kMostScenes && isLauncherThere(path_ + "/launcher"))
    std::this_thread::sleep_for(kPause);
}

void CaptureFolder::add(uint64_t frame, const saved::SavedScene& scene) const {
  waitForLauncher();
  if (const std::string why = saved::saveScene(scene, fileOf(frame, "gluray")); !why.empty())
    files::replace(fileOf(frame, "why"), why);
}

void CaptureFolder::end(uint64_t frames) const { files::replace(path_ + "/frames", std::to_string(frames)); }

}  // namespace gluray::intercept
