#include "model/comparison.h"

#include "control/messages/members.h"
#include "model/movement.h"
#include "model/shot_fetch.h"

#include <chrono>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr std::chrono::milliseconds kSettled{600};  // without a further size
constexpr size_t kShotOfBatch = 1;                  // place of the shot in it

json windowsOf(const Program& program) {
  const json* const windows = control::member(program.state, "windows");
  return windows ? *windows : json();
}

}  // namespace

Comparison::Comparison(Controls& controls, QObject* parent) : QObject(parent), controls_(controls) {
  settled_.setSingleShot(true);
  settled_.setInterval(kSettled);
  connect(&settled_, &QTimer::timeout, this, &Comparison::renew);
  connect(&controls_, &Controls::stateChanged, this, &Comparison::stateCame);
  connect(&controls_, &Controls::chosenChanged, this, &Comparison::programShown);
  connect(&controls_, &Controls::programsChanged, this, &Comparison::programShown);
}

void Comparison::watch(bool on) {
  on_ = on;
  settled_.stop();
  if (on) return renew();
  ++round_, underWay_ = false;
  image_ = {};
  emit changed();
}

void Comparison::programShown() {
  const Program* program = controls_.shown();
  if (!on_ || (program ? program->number : 0) == program_) return;
  image_ = {};
  underWay_ = false;
  emit changed();
  renew();
}

void Comparison::stateCame(int number) {
  const Program* program = controls_.shown();
  if (!on_ || !program || program->number != number) return;
  if (const json now = windowsOf(*program); now != windows_) {
    windows_ = now;
    settled_.start();
  }
}

void Comparison::renew() {
  const Program* program = controls_.shown();
  program_ = program ? program->number : 0;
  if (!on_ || !program) return;
  if (underWay_) return settled_.start();  // once more
  underWay_ = true;
  windows_ = windowsOf(*program);
  const auto known = program->values.find("engine");
  const json before =
      known != program->values.end() && known->second.layer == "live" ? known->second.value : json();
  const std::string gesture = newGesture();
  const auto set = [&](const json& value) {
    return json{{"type", "set"}, {"values", {{"engine", value}}}, {"gesture", gesture}};
  };
  json requests = json::array();
  requests.push_back(set("never"));
  requests.push_back({{"type", "call"}, {"name", "shot"}, {"arguments", json::object()}});
  requests.push_back(set(before));
  controls_.batch(
      program_, std::move(requests), this,
      [this, round = ++round_](const std::vector<CallAnswer>& answers) { receiveAnswers(answers, round); });
}

void Comparison::receiveAnswers(const std::vector<CallAnswer>& answers, uint64_t round) {
  if (round != round_) return;
  std::string why;
  for (const CallAnswer& answer : answers)
    if (why.empty()) why = answer.why;
  if (why.empty() && answers.size() <= kShotOfBatch) why = "the program's answer cannot be read";
  if (!why.empty()) {
    underWay_ = false;
    return void(emit said(tr("No image of the real OpenGL: %1").arg(QString::fromStdString(why))));
  }
  auto* fetch =
      new ShotFetch(controls_, program_, this, [this, round](const QImage& image, const QString& whyNot) {
        if (round != round_) return;
        underWay_ = false;
        if (!whyNot.isEmpty()) return void(emit said(tr("No image of the real OpenGL: %1").arg(whyNot)));
        image_ = image;
        emit changed();
      });
  fetch->fetch(answers[kShotOfBatch].value);
}

}  // namespace gluray::panel
