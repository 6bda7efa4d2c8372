#include "capture/scene_folder.h"

#include "base/files.h"
#include "base/number_text.h"
#include "base/printable.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostAnswer = 1 << 16;  // bytes

std::optional<uint64_t> numberIn(const std::string& text) {
  uint64_t number = 0;
  return readNumber(text, number) ? std::optional(number) : std::nullopt;
}

}  // namespace

SceneFolder::SceneFolder(const std::string& file) {
  std::string pattern = fs::absolute(file).string() + ".scenes-XXXXXX";
  const auto fail = [&] {
    throw std::runtime_error(printable(file) +
                             " cannot be written: " + std::generic_category().message(errno));
  };
  if (!::mkdtemp(pattern.data())) fail();
  path_ = pattern;
  lock_ = ::open((path_ + "/launcher").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock_ < 0 || ::flock(lock_, LOCK_EX) != 0) fail();
}

SceneFolder::~SceneFolder() {
  if (lock_ >= 0) ::close(lock_);
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::optional<CapturedFrame> SceneFolder::next() const {
  std::optional<CapturedFrame> first;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_, error)) {
    const bool isScene = entry.path().extension() == ".gluray", isWhy = entry.path().extension() == ".why";
    const auto number = numberIn(entry.path().stem());
    if ((!isScene && !isWhy) || !number || (first && first->frame <= *number)) continue;
    first = {.frame = *number};
    isScene ? first->scene = entry.path() : first->why = files::read(entry.path(), kMostAnswer).text;
  }
  return first;
}

void SceneFolder::remove(const CapturedFrame& frame) const {
  for (const auto& entry : fs::directory_iterator(path_))
    if (numberIn(entry.path().stem()) == frame.frame) {
      std::error_code ignored;
      fs::remove(entry.path(), ignored);
    }
}

std::optional<uint64_t> SceneFolder::frames() const {
  return numberIn(files::read(path_ + "/frames", kMostAnswer).text);
}

}  // namespace gluray::launcher
