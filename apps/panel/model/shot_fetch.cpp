#include "model/shot_fetch.h"

#include "control/messages/base64.h"
#include "control/messages/members.h"
#include "model/controls.h"

#include <cstring>
#include <limits>
#include <utility>

namespace gluray::panel {
namespace {

using control::member, control::textIn, control::wholeNumber;
using nlohmann::json;

constexpr int kMaxSide = 1 << 15;  // of an image
constexpr int64_t kMaxPixels = int64_t{1} << 26;

}  // namespace

ShotFetch::ShotFetch(Controls& controls, int program, QObject* parent, Taker then)
    : QObject(parent), controls_(controls), program_(program), then_(std::move(then)) {}

void ShotFetch::shoot() {
  controls_.call(program_, "shot", json::object(), this, [this](const CallAnswer& answer) {
    answer.why.empty() ? fetch(answer.value) : finish({}, answer.why);
  });
}

void ShotFetch::fetch(const json& shot) {
  const auto number = wholeNumber(member(shot, "shot"), 0, std::numeric_limits<int>::max());
  const auto width = wholeNumber(member(shot, "width"), 1, kMaxSide),
             height = wholeNumber(member(shot, "height"), 1, kMaxSide);
  if (!number || !width || !height || *width * *height > kMaxPixels)
    return finish({}, "the program's shot cannot be read");
  shot_ = static_cast<int>(*number);
  image_ = QImage(static_cast<int>(*width), static_cast<int>(*height), QImage::Format_RGB888);
  image_.isNull() ? finish({}, "there is no memory for the image") : askRow();
}

void ShotFetch::askRow() {
  controls_.call(program_, "pixels", {{"shot", shot_}, {"row", row_}}, this,
                 [this](const CallAnswer& answer) {
                   const std::string why = answer.why.empty() ? takeRows(answer.value) : answer.why;
                   if (!why.empty()) return finish({}, why);
                   row_ < image_.height() ? askRow() : finish(image_, "");
                 });
}

std::string ShotFetch::takeRows(const json& piece) {
  const auto row = wholeNumber(member(piece, "row"), row_, row_),
             rows = wholeNumber(member(piece, "rows"), 1, image_.height() - row_);
  const auto bytes = control::fromBase64(textIn(piece, "pixels"));
  const size_t line = 3 * static_cast<size_t>(image_.width());
  if (!row || !rows || !bytes || bytes->size() != line * static_cast<size_t>(*rows))
    return "the program's pixels cannot be read";
  for (size_t i = 0; i < static_cast<size_t>(*rows); ++i)
    std::memcpy(image_.scanLine(row_ + static_cast<int>(i)), bytes->data() + i * line, line);
  row_ += static_cast<int>(*rows);
  return "";
}

void ShotFetch::finish(const QImage& image, const std::string& why) {
  deleteLater();
  if (const Taker then = std::exchange(then_, nullptr)) then(image, QString::fromStdString(why));
}

}  // namespace gluray::panel
