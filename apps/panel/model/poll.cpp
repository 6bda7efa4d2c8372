#include "model/poll.h"

#include "model/controls.h"

#include <chrono>

namespace gluray::panel {
namespace {

constexpr std::chrono::milliseconds kBetweenCalls{1000};

}  // namespace

Poll::Poll(Controls& controls, const char* name, QObject* parent)
    : QObject(parent), controls_(controls), name_(name) {
  timer_.setInterval(kBetweenCalls);
  connect(&timer_, &QTimer::timeout, this, &Poll::ask);
  connect(&controls_, &Controls::chosenChanged, this, &Poll::restart);
  connect(&controls_, &Controls::programsChanged, this, &Poll::restart);
}

void Poll::watch(bool on) {
  watched_ = on;
  on ? timer_.start() : timer_.stop();
  restart();
  ask();
}

void Poll::restart() {
  const Program* program = controls_.shown();
  if (program_ == (program ? program->number : 0)) return;
  program_ = program ? program->number : 0;
  underWay_ = false;
  ++round_;
  emit restarted();
  ask();
}

void Poll::ask() {
  if (!watched_ || underWay_ || program_ == 0) return;
  underWay_ = true;
  controls_.call(program_, name_, nlohmann::json::object(), this,
                 [this, round = ++round_](const CallAnswer& answer) {
                   if (round != round_) return;
                   underWay_ = false;
                   emit answered(answer);
                 });
}

}  // namespace gluray::panel
