#include "control/images/window_image.h"

#include "base/printable.h"
#include "control/messages/base64.h"
#include "control/messages/members.h"
#include "control/one_program.h"

#include <filesystem>
#include <fstream>
#include <string_view>

namespace gluray::launcher {
namespace {

using nlohmann::json;

constexpr int kMaxSide = 1 << 15;  // pixels
const char kNoImage[] = "it sends no image";

bool isNamed(const std::string& file, std::string_view ending) {
  return file.ends_with(ending) && file.size() > ending.size();
}

/// What keeps a file of this name from being replaced: it is another one than such a `form`, which begins
/// with `magic`.
std::string whyNotOver(const std::string& file, std::string_view magic, const char* form) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) return "";
  std::string begin(magic.size(), '\0');
  const bool regular = std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error));
  if (regular)
    std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin == magic) return "";
  return printable(file) + " exists and is no " + form + " file; remove it, or use another name";
}

int sideIn(const json& value, const char* name, int most) {
  const auto side = control::wholeNumber(control::member(value, name), 1, most);
  if (!side) throw std::runtime_error(kNoImage);
  return static_cast<int>(*side);
}

}  // namespace

std::string whyNotInto(const std::string& file) {
  if (!isNamed(file, ".png")) return printable(file) + ": use a name that ends in .png";
  return whyNotOver(file, "\x89PNG\r\n\x1a\n", "PNG");
}

std::string whyNoPictureInto(const std::string& file) {
  if (isNamed(file, ".exr")) return whyNotOver(file, "\x76\x2f\x31\x01", "OpenEXR");
  return isNamed(file, ".png") ? whyNotInto(file)
                               : printable(file) + ": use a name that ends in .png or .exr";
}

Shot takeShot(HubSession& hub, const RunningProgram& program) {
  const json value = callOf(hub, program, "shot", json::object());
  return {value.value("shot", json()), sideIn(value, "width", kMaxSide), sideIn(value, "height", kMaxSide),
          control::wholeNumber(control::member(value, "frame"), 0, control::kMaxFrame)};
}

WindowImage imageOf(HubSession& hub, const RunningProgram& program, const Shot& shot) {
  WindowImage image{{shot.width, shot.height, 3, {}}, shot.frame};
  const size_t rowBytes = 3 * static_cast<size_t>(shot.width);
  for (int row = 0; row < shot.height;) {
    const json piece = callOf(hub, program, "pixels", {{"shot", shot.number}, {"row", row}});
    const int rows = sideIn(piece, "rows", shot.height - row);
    const auto bytes = control::fromBase64(control::textIn(piece, "pixels"));
    if (!bytes || bytes->size() != rowBytes * static_cast<size_t>(rows)) throw std::runtime_error(kNoImage);
    image.pixels.bytes.insert(image.pixels.bytes.end(), bytes->begin(), bytes->end());
    row += rows;
  }
  return image;
}

WindowImage imageOf(HubSession& hub, const RunningProgram& program) {
  return imageOf(hub, program, takeShot(hub, program));
}

}  // namespace gluray::launcher
