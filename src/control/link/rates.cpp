#include "control/link/rates.h"

namespace gluray::control {

void Rates::sample(uint64_t frame, const Figures& figures, double now) {
  if (!samples_.empty()) {
    const Sample& last = samples_.back();
    if (now < last.time || frame < last.frame) return;
    if (frame > last.frame) triangles_ = (figures.triangles - last.figures.triangles) / (frame - last.frame);
  }
  samples_.push_back({frame, figures, now});
  while (samples_.size() > 2 && samples_[1].time <= now - kSpan) samples_.pop_front();
}

double Rates::framesPerSecond() const {
  if (samples_.size() < 2) return 0;
  const Sample &first = samples_.front(), &last = samples_.back();
  const double seconds = last.time - first.time;
  return seconds > 0 ? static_cast<double>(last.frame - first.frame) / seconds : 0;
}

std::optional<double> Rates::traced() const {
  if (samples_.size() < 2) return std::nullopt;
  const Figures &first = samples_.front().figures, &last = samples_.back().figures;
  const auto traced = static_cast<double>(last.traced - first.traced);
  const double all = traced + static_cast<double>(last.rasterised - first.rasterised);
  return all > 0 ? std::optional(traced / all) : std::nullopt;
}

}  // namespace gluray::control
