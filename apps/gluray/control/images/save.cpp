#include "control/images/save.h"

#include "base/printable.h"
#include "control/images/window_image.h"
#include "control/messages/members.h"
#include "control/one_program.h"
#include "pictures/export.h"
#include "saved/sections/saved_picture.h"
#include "say.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kSceneEnding = ".gluray";

/// The part of a window that shows the scene.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;  // pixels, from the lower left corner
};

/// None: not known, or not in a window of this size.
std::optional<Box> boxIn(const json& saved, const Pixels& window) {
  const auto found = saved.find("box");
  if (found == saved.end() || !found->is_array() || found->size() != 4) return std::nullopt;
  std::array<int, 4> values{};
  for (size_t i = 0; i < values.size(); ++i) {
    const auto value = control::wholeNumber(&(*found)[i], 0, 1 << 16);
    if (!value) return std::nullopt;
    values[i] = static_cast<int>(*value);
  }
  const Box box{values[0], values[1], values[2], values[3]};
  const bool inside = box.x + box.width <= window.width && box.y + box.height <= window.height;
  return inside ? std::optional(box) : std::nullopt;
}

saved::SavedPicture pictureOf(const Pixels& pixels, const Box& box) {
  saved::SavedPicture picture{box.width, box.height, {}};
  for (int y = pixels.height - 1 - box.y; y >= pixels.height - box.y - box.height; --y)
    for (int x = box.x; x < box.x + box.width; ++x) {
      const uint8_t* const rgb =
          pixels.at(static_cast<size_t>(y) * static_cast<size_t>(pixels.width) + static_cast<size_t>(x));
      picture.pixels.push_back(0xff000000u | static_cast<uint32_t>(rgb[0]) |
                               static_cast<uint32_t>(rgb[1]) << 8 | static_cast<uint32_t>(rgb[2]) << 16);
    }
  return picture;
}

/// A file that is removed unless it was renamed.
struct PartFile {
  std::string path;
  explicit PartFile(const std::string& file) : path(file + ".part-" + std::to_string(getpid())) {}
  ~PartFile() {
    std::error_code error;
    fs::remove(path, error);
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  /// Makes it anew, empty: the program writes into it.
  void begin() const {
    ::unlink(path.c_str());
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw std::runtime_error(printable(path) +
                               " cannot be written: " + std::generic_category().message(errno));
    ::close(descriptor);
  }
  void renameTo(const std::string& file) const {
    std::error_code error;
    fs::rename(path, file, error);
    if (error) throw std::runtime_error(printable(file) + " cannot be written: " + error.message());
  }
};

/// Large scenes take longer than a hub waits for an answer.
void waitUntilSaved(HubSession& hub, const RunningProgram& program, const std::string& file) {
  constexpr std::chrono::milliseconds kPause{20};
  while (!callOf(hub, program, "saved", {{"file", file}}).value("saved", false))
    std::this_thread::sleep_for(kPause);
}

}  // namespace

void saveScene(HubSession& hub, const RunningProgram& program, const std::string& file) {
  if (runsElsewhere(program))
    throw std::runtime_error("it runs on " + printable(program.host) + ": use this command there");
  const PartFile part(fs::absolute(file).string());
  // Scene and picture must be of one frame. Programs that draw all the time may show others in between.
  constexpr int kTries = 5;
  for (int left = kTries; left > 0; --left) {
    part.begin();
    const Shot shot = takeShot(hub, program);
    const json saved = callOf(hub, program, "save", {{"file", part.path}});
    const auto frame = control::wholeNumber(control::member(saved, "frame"), 0, control::kMaxFrame);
    waitUntilSaved(hub, program, part.path);
    if (frame && shot.frame && *frame != *shot.frame && left > 1) continue;
    if (frame && shot.frame && *frame != *shot.frame)
      throw std::runtime_error("it shows new frames all the time: pause its animation");
    const Pixels window = imageOf(hub, program, shot).pixels;
    const std::optional<Box> box = boxIn(saved, window);
    const std::string why = box ? saved::appendPicture(part.path, pictureOf(window, *box)) : "";
    if (!why.empty()) throw std::runtime_error(why);
    break;
  }
  part.renameTo(file);
}

namespace {

/// By way of a saved scene beside the file.
std::vector<std::string> saveInOtherForm(HubSession& hub, const RunningProgram& program,
                                         const std::string& file) {
  const PartFile scene(fs::absolute(file).string() + kSceneEnding);
  saveScene(hub, program, scene.path);
  return exportScene(scene.path, file);
}

}  // namespace

int saveProgramsScene(const CommandLine& line) {
  const std::string file = line.control.file;
  const bool own = file.ends_with(kSceneEnding) && file.size() > kSceneEnding.size();
  if (!own && !isOtherForm(file))
    return say(printable(file) + ": use a name that ends in .gluray, or in .glb, .obj or .ply"), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  std::vector<std::string> notes;
  labelled(program,
           [&] { own ? saveScene(hub, program, file) : void(notes = saveInOtherForm(hub, program, file)); });
  for (const std::string& note : notes) say(note);
  std::error_code error;
  const auto bytes = fs::file_size(file, error);
  if (line.json) {
    json found = named(program);
    found["file"] = file, found["bytes"] = bytes, found["notes"] = notes;
    std::cout << jsonText(found) << "\n";
  } else {
    std::cout << labelOf(program) << ": " << printable(file) << ", " << (bytes + 999999) / 1000000 << " MB\n";
  }
  return 0;
}

}  // namespace gluray::launcher
