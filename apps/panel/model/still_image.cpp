#include "model/still_image.h"

#include "model/shot_fetch.h"

#include <algorithm>
#include <chrono>

namespace gluray::panel {
namespace {

constexpr std::chrono::milliseconds kQuiet{800};
constexpr int kBetweenShots = 3000;  // milliseconds

}  // namespace

StillImage::StillImage(Controls& controls, QObject* parent) : QObject(parent), controls_(controls) {
  quiet_.setSingleShot(true);
  connect(&quiet_, &QTimer::timeout, this, &StillImage::shoot);
  connect(&controls_, &Controls::thumbnailChanged, this, &StillImage::thumbnailCame);
  connect(&controls_, &Controls::chosenChanged, this, &StillImage::forget);
  connect(&controls_, &Controls::programsChanged, this, [this] {
    if (!controls_.shown()) forget();
  });
}

void StillImage::watch(bool on) {
  on_ = on;
  forget();
}

void StillImage::forget() {
  ++round_;
  underWay_ = false;
  thumbnail_ = {};
  emit changed({});
  on_&& controls_.shown() ? quiet_.start(kQuiet) : quiet_.stop();
}

/// A shot makes the program draw: the same thumbnail again says nothing new.
void StillImage::thumbnailCame(int number) {
  const Program* program = controls_.shown();
  if (!on_ || !program || program->number != number || program->thumbnail == thumbnail_) return;
  thumbnail_ = program->thumbnail;
  ++round_;
  emit changed({});
  const int rest = last_.isValid()
                       ? kBetweenShots - static_cast<int>(std::min<qint64>(last_.elapsed(), kBetweenShots))
                       : 0;
  quiet_.start(std::max(kQuiet, std::chrono::milliseconds(rest)));
}

void StillImage::shoot() {
  const Program* program = controls_.shown();
  if (!on_ || !program) return;
  if (underWay_) return quiet_.start(kQuiet);
  underWay_ = true;
  last_.start();
  auto* fetch = new ShotFetch(controls_, program->number, this,
                              [this, round = round_](const QImage& image, const QString&) {
                                underWay_ = false;
                                if (round == round_ && !image.isNull()) emit changed(image);
                              });
  fetch->shoot();
}

}  // namespace gluray::panel
