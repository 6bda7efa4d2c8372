#include "model/film.h"

#include "model/movement.h"
#include "model/save_image.h"
#include "model/shot_fetch.h"

#include <QDir>
#include <QFile>
#include <cmath>
#include <utility>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr int kDigitsOfFrames = 4;

json setRequest(const std::string& name, const json& value, const std::string& gesture) {
  return {{"type", "set"}, {"values", {{name, value}}}, {"gesture", gesture}};
}

}  // namespace

Film::Film(Controls& controls, FilmPlan plan, QObject* parent)
    : QObject(parent),
      controls_(controls),
      plan_(std::move(plan)),
      program_(controls.shown()->number),
      gesture_(newGesture()) {
  const Value value = controls.value(plan_.setting);
  if (value.layer == "live") before_ = value.value;
}

QString Film::fileOf(int frame) const {
  return QDir(plan_.folder)
      .filePath(QString("%1-%2.png").arg(plan_.name).arg(frame + 1, kDigitsOfFrames, 10, QChar('0')));
}

void Film::start() {
  connect(&controls_, &Controls::programsChanged, this, [this] {
    if (!controls_.find(program_)) finish(tr("the program has ended"));
  });
  askNextImage();
}

void Film::stop() {
  stopped_ = true;
  finish({});
}

json Film::valueOf(int frame) const {
  const double share = plan_.frames > 1 ? static_cast<double>(frame) / (plan_.frames - 1) : 0;
  const double value = plan_.from + (plan_.to - plan_.from) * share;
  return plan_.whole ? json(std::llround(value)) : json(value);
}

void Film::askNextImage() {
  if (finished_) return;
  if (plan_.frames > 0 && saved_ >= plan_.frames) return finish({});
  if (QFile::exists(fileOf(saved_))) return finish(tr("%1 exists already").arg(fileOf(saved_)));
  if (plan_.setting.empty()) return shoot();
  varied_ = true;
  // The shot is asked for when the program has taken the value: its next frame has it.
  controls_.batch(program_, json::array({setRequest(plan_.setting, valueOf(saved_), gesture_)}), this,
                  [this](const std::vector<CallAnswer>& answers) {
                    const std::string why = answers.empty() ? "" : answers.front().why;
                    why.empty() ? shoot() : finish(QString::fromStdString(why));
                  });
}

void Film::shoot() {
  if (finished_) return;
  auto* fetch = new ShotFetch(controls_, program_, this,
                              [this](const QImage& image, const QString& why) { receiveImage(image, why); });
  fetch->shoot();
}

void Film::receiveImage(const QImage& image, const QString& why) {
  if (finished_) return;
  if (!why.isEmpty()) return finish(why);
  saveImage(image, fileOf(saved_), this, [this](const QString& whyNot) {
    if (!whyNot.isEmpty()) return finish(whyNot);
    emit progressed(++saved_);
    askNextImage();
  });
}

void Film::finish(const QString& why) {
  if (std::exchange(finished_, true)) return;
  if (varied_ && controls_.find(program_))  // what the setting was: the gesture ends where it began
    controls_.batch(program_, json::array({setRequest(plan_.setting, before_, gesture_)}), this,
                    [](const std::vector<CallAnswer>&) {});
  emit finished(why);
}

}  // namespace gluray::panel
