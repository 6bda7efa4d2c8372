#include "pages/live/light_drag.h"

#include "control/messages/members.h"
#include "pages/light/light_direction.h"
#include "pages/live/image_call.h"

#include <algorithm>
#include <utility>

namespace gluray::panel {
namespace {

using control::member;
using nlohmann::json;

constexpr double kMaxAzimuth = 360, kMaxElevation = 90;

}  // namespace

LightDrag::LightDrag(Controls& controls, QObject* parent)
    : QObject(parent), controls_(controls), movement_(controls, this) {}

void LightDrag::point(const ImagePoint& at, LiveImage::Stage stage) {
  const Program* program = controls_.shown();
  if (!program) return;
  if (stage == LiveImage::Stage::press) {
    movement_.end();
    ++drag_;
    program_ = program->number;
    if (const QString line = lineAboutRig(controls_); !line.isEmpty()) emit said(line);
  }
  released_ = stage == LiveImage::Stage::release;
  if (program_ != program->number) return finish();
  next_ = at;
  ask();
}

void LightDrag::ask() {
  if (underWay_ || !next_) return;
  underWay_ = true;
  controls_.call(program_, "highlight", argumentsOf(*std::exchange(next_, std::nullopt)), this,
                 [this, drag = drag_](const CallAnswer& answer) { receiveAnswer(answer, drag); });
}

void LightDrag::receiveAnswer(const CallAnswer& answer, uint64_t drag) {
  underWay_ = false;
  if (drag != drag_) return ask();
  const Program* program = controls_.shown();
  if (!program || program->number != program_) return finish();
  const json* const azimuth = member(answer.value, "azimuth");
  const json* const elevation = member(answer.value, "elevation");
  const bool last = released_ && !next_;
  if (!answer.why.empty()) {
    emit said(QString::fromStdString(answer.why));
  } else if (azimuth && elevation && azimuth->is_number() && elevation->is_number()) {
    const LightDirection direction{std::clamp(azimuth->get<double>(), -kMaxAzimuth, kMaxAzimuth),
                                   std::clamp(elevation->get<double>(), -kMaxElevation, kMaxElevation)};
    movement_.send(lightValues(controls_, direction), !last);
  }
  if (last) return finish();
  ask();
}

void LightDrag::finish() {
  next_.reset();
  movement_.end();
}

}  // namespace gluray::panel
