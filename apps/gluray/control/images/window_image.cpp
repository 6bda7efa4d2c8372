#include "control/images/window_image.h"

#include "base/printable.h"
#include "control/messages/base64.h"
#include "control/messages/members.h"
#include "control/one_program.h"

#include <array>
#include <filesystem>
#include <fstream>

namespace gluray::launcher {
namespace {

using nlohmann::json;

constexpr int kMaxSide = 1 << 15;  // pixels
const char kNoImage[] = "it sends no image";

int sideIn(const json& value, const char* name, int most) {
  const auto side = control::wholeNumber(control::member(value, name), 1, most);
  if (!side) throw std::runtime_error(kNoImage);
  return static_cast<int>(*side);
}

}  // namespace

std::string whyNotInto(const std::string& file) {
  if (!file.ends_with(".png") || file.size() < 5) return printable(file) + ": use a name that ends in .png";
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) return "";
  constexpr std::array<unsigned char, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  std::array<unsigned char, 8> begin{};
  const bool regular = std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error));
  if (regular)
    std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(begin.data()), begin.size());
  return begin == kPng ? "" : printable(file) + " exists and is no PNG file; remove it, or use another name";
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
