#include "pages/live/image_call.h"

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

constexpr int64_t kMaxObjectNumber = std::numeric_limits<uint32_t>::max();

QString textOfNumber(double value) { return QString::number(value, 'g', 4); }

QString lineOf(uint32_t object, const json& answer) {
  if (object == 0) return QObject::tr("There is no traced object at this point.");
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

/// Where the point lies in its view; none: the answer cannot be read.
std::optional<std::array<double, 2>> shareIn(const json& answer) {
  const json* const share = member(answer, "share");
  if (!share || !share->is_array() || share->size() != 2 || !(*share)[0].is_number() ||
      !(*share)[1].is_number())
    return std::nullopt;
  return {{std::clamp((*share)[0].get<double>(), 0.0, 1.0), std::clamp((*share)[1].get<double>(), 0.0, 1.0)}};
}

double thousandths(double value) { return std::round(value * 1000) / 1000; }

QString focusLine(const Controls& controls, int64_t object) {
  if (controls.value("camera.aperture").value == 0 && controls.value("camera.f-number").value == 0)
    return QObject::tr(
        "The focus is there; nothing is blurred while camera.aperture and camera.f-number are 0.");
  return QObject::tr("Object %1 is in focus.").arg(object);
}

}  // namespace

json argumentsOf(const ImagePoint& at) {
  return {{"x", at.x}, {"y", at.y}, {"width", at.width}, {"height", at.height}};
}

void pickObject(Controls& controls, const ImagePoint& at, QObject* receiver,
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
                      wholeNumber(member(answer.value, "object"), 1, kMaxObjectNumber).value_or(0));
                  then(number, object, lineOf(object, answer.value));
                });
}

void focusOn(Controls& controls, const ImagePoint& at, QObject* receiver,
             std::function<void(const QString&)> said) {
  const Program* shown = controls.shown();
  if (!shown) return;
  controls.call(shown->number, "pick", argumentsOf(at), receiver,
                [&controls, number = shown->number, said = std::move(said)](const CallAnswer& answer) {
                  const Program* program = controls.shown();
                  if (!program || program->number != number) return;
                  if (!answer.why.empty()) return said(QString::fromStdString(answer.why));
                  if (const json* const object = member(answer.value, "object"); object && object->is_null())
                    return said(QObject::tr("There is no traced object at this point; the focus stays."));
                  const auto object = wholeNumber(member(answer.value, "object"), 1, kMaxObjectNumber);
                  const auto share = shareIn(answer.value);
                  if (!object || !share) return said(QObject::tr("the program's answer cannot be read"));
                  controls.change({{"camera.focus", 0},
                                   {"camera.focus-x", thousandths((*share)[0])},
                                   {"camera.focus-y", thousandths((*share)[1])}});
                  said(focusLine(controls, *object));
                });
}

}  // namespace gluray::panel
