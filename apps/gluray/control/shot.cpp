#include "control/shot.h"

#include "base/files.h"
#include "base/printable.h"
#include "control/hub_session.h"
#include "control/messages/base64.h"
#include "explain/pixels.h"
#include "say.h"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

constexpr int kMostSide = 1 << 15;  // pixels
const char kNoPicture[] = "it sends no picture";

/// What keeps the file from being written; empty: nothing is known.
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

int sideIn(const json& value, const char* name, int most) {
  const auto found = value.find(name);
  if (found == value.end() || !found->is_number_integer()) throw std::runtime_error(kNoPicture);
  const auto side = found->get<int64_t>();
  if (side < 1 || side > most) throw std::runtime_error(kNoPicture);
  return static_cast<int>(side);
}

/// The value that a call of the program returns. Throws.
json callOf(HubSession& hub, const RunningProgram& program, const char* name, const json& arguments) {
  const json answer =
      hub.ask({{"type", "call"}, {"program", program.number}, {"name", name}, {"arguments", arguments}});
  json value;
  forEachResult(answer, {program}, [&](const RunningProgram&, const json& result) {
    if (const std::string why = whyFailed(result); !why.empty()) throw std::runtime_error(why);
    value = result.value("value", json::object());
  });
  if (!value.is_object()) throw std::runtime_error(kNoPicture);
  return value;
}

/// Takes a shot and fetches its rows. Throws.
Pixels shotOf(HubSession& hub, const RunningProgram& program, json& frame) {
  const json shot = callOf(hub, program, "shot", json::object());
  Pixels pixels;
  pixels.width = sideIn(shot, "width", kMostSide), pixels.height = sideIn(shot, "height", kMostSide);
  frame = shot.value("frame", json());
  const size_t rowBytes = 3 * static_cast<size_t>(pixels.width);
  for (int row = 0; row < pixels.height;) {
    const json piece = callOf(hub, program, "pixels", {{"shot", shot.value("shot", json())}, {"row", row}});
    const int rows = sideIn(piece, "rows", pixels.height - row);
    const json text = piece.value("pixels", json());
    const auto bytes = control::fromBase64(text.is_string() ? text.get<std::string>() : "");
    if (!bytes || bytes->size() != rowBytes * static_cast<size_t>(rows)) throw std::runtime_error(kNoPicture);
    pixels.bytes.insert(pixels.bytes.end(), bytes->begin(), bytes->end());
    row += rows;
  }
  return pixels;
}

}  // namespace

int saveShot(const CommandLine& line) {
  const std::string file = line.control.file;
  if (const std::string why = whyNotInto(file); !why.empty()) return say(why), kUsageError;
  HubSession hub(line);
  const std::vector<RunningProgram> programs = chosenPrograms(hub.programs(), line.control.programs);
  if (programs.size() > 1) return say("several programs run; choose one with -p"), 1;
  const RunningProgram& program = programs.front();
  json frame;
  Pixels pixels;
  try {
    pixels = shotOf(hub, program, frame);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(labelOf(program) + ": " + error.what());
  }
  if (const std::string why = files::replace(file, pngOf(pixels)); !why.empty()) return say(why), 1;
  if (line.json)
    std::cout << jsonText({{"program", program.number},
                           {"name", program.name},
                           {"pid", program.pid},
                           {"frame", frame},
                           {"file", file},
                           {"width", pixels.width},
                           {"height", pixels.height}})
              << "\n";
  else
    std::cout << labelOf(program) << ": " << printable(file) << ", " << pixels.width << " x " << pixels.height
              << "\n";
  return 0;
}

}  // namespace gluray::launcher
