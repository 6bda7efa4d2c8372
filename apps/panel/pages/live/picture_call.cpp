#include "pages/live/picture_call.h"

#include "control/messages/members.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gluray::panel {
namespace {

using control::member, control::wholeNumber;
using nlohmann::json;

constexpr int64_t kMostObject = std::numeric_limits<uint32_t>::max();

QString textOfNumber(double value) { return QString::number(value, 'g', 4); }

QString lineOf(uint32_t object, const json& answer) {
  if (object == 0) return QObject::tr("Nothing that GLuRay traces is there.");
  QString line = QObject::tr("Object %1").arg(object);
  if (const json* at = member(answer, "position");
      at && at->is_array() && at->size() == 3 &&
      std::all_of(at->begin(), at->end(), [](const json& c) { return c.is_number(); }))
    line += QObject::tr(" at %1, %2, %3")
                .arg(textOfNumber((*at)[0].get<double>()), textOfNumber((*at)[1].get<double>()),
                     textOfNumber((*at)[2].get<double>()));
  if (const json* distance = member(answer, "distance"); distance && distance->is_number())
    line += QObject::tr(", distance %1").arg(textOfNumber(distance->get<double>()));
  return line;
}

/// x, y from the bottom, width, height in pixels.
using Viewport = std::array<double, 4>;

std::optional<Viewport> viewportOf(const json& cameras, int64_t view) {
  const json* const list = member(cameras, "cameras");
  if (!list || !list->is_array()) return std::nullopt;
  for (const json& camera : *list) {
    const json* const viewport = member(camera, "viewport");
    if (wholeNumber(member(camera, "view"), 1, kMostObject) != view || !viewport || !viewport->is_array() ||
        viewport->size() != 4)
      continue;
    Viewport result{};
    for (size_t i = 0; i < 4; ++i)
      if ((*viewport)[i].is_number()) result[i] = (*viewport)[i].get<double>();
    if (result[2] >= 1 && result[3] >= 1) return result;
  }
  return std::nullopt;
}

/// Width and height of the program's window; where it has several, of that with the picture's form.
std::optional<std::array<double, 2>> windowOf(const Program& program, const PicturePoint& at) {
  const json* const windows = member(program.state, "windows");
  if (!windows || !windows->is_array()) return std::nullopt;
  std::optional<std::array<double, 2>> best;
  double least = HUGE_VAL;
  for (const json& window : *windows) {
    const double width = control::numberIn(window, "width", 0.0),
                 height = control::numberIn(window, "height", 0.0);
    if (width < 1 || height < 1) continue;
    const double off = std::abs(std::log(width / height * at.height / at.width));
    if (off < least) least = off, best = {width, height};
  }
  return best;
}

/// The place in shares of its view's width and height, from the lower left corner.
std::array<double, 2> sharesOf(const Program& program, const PicturePoint& at,
                               const std::vector<CallAnswer>& answers) {
  const double x = (at.x + 0.5) / at.width, y = 1 - (at.y + 0.5) / at.height;
  const auto window = windowOf(program, at);
  std::optional<Viewport> view;
  if (const auto number = wholeNumber(member(answers[0].value, "view"), 1, kMostObject);
      number && answers.size() > 1)
    view = viewportOf(answers[1].value, *number);
  if (!window || !view) return {x, y};
  return {std::clamp((x * (*window)[0] - (*view)[0]) / (*view)[2], 0.0, 1.0),
          std::clamp((y * (*window)[1] - (*view)[1]) / (*view)[3], 0.0, 1.0)};
}

double thousandths(double value) { return std::round(value * 1000) / 1000; }

QString focusLine(const Controls& controls, const std::vector<CallAnswer>& answers) {
  if (controls.value("camera.aperture").value == 0 && controls.value("camera.f-number").value == 0)
    return QObject::tr(
        "The focus is there; nothing is blurred while camera.aperture and camera.f-number are 0.");
  const auto object = wholeNumber(member(answers[0].value, "object"), 1, kMostObject);
  return object ? QObject::tr("Object %1 is in focus.").arg(*object) : QObject::tr("The focus is there.");
}

}  // namespace

json argumentsOf(const PicturePoint& at) {
  return {{"x", at.x}, {"y", at.y}, {"width", at.width}, {"height", at.height}};
}

void pickObject(Controls& controls, const PicturePoint& at, QObject* receiver,
                std::function<void(int, uint32_t, const QString&)> then,
                std::function<void(const QString&)> failed) {
  const Program* program = controls.shown();
  if (!program) return;
  controls.call(program->number, "pick", argumentsOf(at), receiver,
                [number = program->number, then = std::move(then),
                 failed = std::move(failed)](const CallAnswer& answer) {
                  if (!answer.why.empty()) return failed(QString::fromStdString(answer.why));
                  if (!answer.value.is_object())
                    return failed(QObject::tr("the program's answer cannot be read"));
                  const auto object = static_cast<uint32_t>(
                      wholeNumber(member(answer.value, "object"), 1, kMostObject).value_or(0));
                  then(number, object, lineOf(object, answer.value));
                });
}

void focusOn(Controls& controls, const PicturePoint& at, QObject* receiver,
             std::function<void(const QString&)> said) {
  const Program* shown = controls.shown();
  if (!shown) return;
  const json requests = {{{"type", "call"}, {"name", "pick"}, {"arguments", argumentsOf(at)}},
                         {{"type", "call"}, {"name", "cameras"}, {"arguments", json::object()}}};
  controls.batch(
      shown->number, requests, receiver,
      [&controls, at, number = shown->number,
       said = std::move(said)](const std::vector<CallAnswer>& answers) {
        const Program* program = controls.shown();
        if (!program || program->number != number || answers.empty()) return;
        const json* const object = member(answers[0].value, "object");
        if (answers[0].why.empty() && object && object->is_null())
          return said(QObject::tr("Nothing that GLuRay traces is there; the focus stays."));
        const auto [x, y] = sharesOf(*program, at, answers);
        controls.change(
            {{"camera.focus", 0}, {"camera.focus-x", thousandths(x)}, {"camera.focus-y", thousandths(y)}});
        said(focusLine(controls, answers));
      });
}

}  // namespace gluray::panel
