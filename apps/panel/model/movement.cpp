#include "model/movement.h"

#include "model/controls.h"

#include <QCoreApplication>
#include <chrono>
#include <utility>

namespace gluray::panel {
namespace {

// Between two changes of a movement. A hub takes 256 requests that wait, each for six seconds at most.
constexpr std::chrono::milliseconds kPause{25};

constexpr int kApart = 1000;  // milliseconds

}  // namespace

std::string newGesture() {
  static uint64_t last = 0;
  return "panel " + std::to_string(QCoreApplication::applicationPid()) + " " + std::to_string(++last);
}

Movement::Movement(Controls& controls, QObject* parent) : QObject(parent), controls_(controls) {
  pause_.setSingleShot(true);
  connect(&pause_, &QTimer::timeout, this, [this] {
    if (waits_) send(nlohmann::json(*waits_), true);
  });
}

bool Movement::send(const nlohmann::json& values, bool more) {
  const bool begins = gesture_.empty() || (!moving_ && (more || last_.elapsed() > kApart));
  if (begins) gesture_ = newGesture();
  moving_ = more;
  last_.start();
  waits_.reset();
  if (more && pause_.isActive()) {
    waits_ = values;
    return begins;
  }
  more ? pause_.start(kPause) : pause_.stop();
  controls_.change(values, gesture_);
  return begins;
}

void Movement::end() {
  if (waits_) send(nlohmann::json(*std::exchange(waits_, std::nullopt)), false);
  moving_ = false;
  pause_.stop();
}

void Movement::beginNextMovement() {
  end();
  gesture_.clear();
}

}  // namespace gluray::panel
