#include "pages/plots/plot.h"

#include "control/messages/members.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::panel {
namespace {

constexpr double kHeadroom = 1.05;  // a steady line does not lie on the edge
constexpr double kMinNoise = 1e-6;

/// The newest value, not a number: there is none.
double newestOf(const std::deque<double>& values) { return values.empty() ? std::nan("") : values.back(); }

}  // namespace

Plot::Plot(Controls& controls, const QString& name, QWidget* parent) : ShownWidget(controls, name, parent) {
  connect(&controls, &Controls::stateChanged, this, [this](int number) {
    if (program() && program()->number == number) stateCame();
  });
}

QSize Plot::sizeHint() const { return {240, fontMetrics().height() * 5}; }

double Plot::topFor(const std::deque<double>& values, double least) {
  double most = least;
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, value * kHeadroom);
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {1.0, 2.0, 5.0})
    if (most <= step * power) return step * power;
  return 10 * power;
}

void Plot::paintLine(const std::deque<double>& values, double top, QPalette::ColorRole color) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double room = height() - 2.0, step = width() / (static_cast<double>(kMaxPlottedEvents) - 1);
  QPainterPath path;
  bool gap = true;
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      gap = true;
      continue;
    }
    const double share = std::clamp(values[i] / top, 0.0, 1.0);
    const QPointF at(width() - step * static_cast<double>(values.size() - 1 - i), 1 + room * (1 - share));
    gap ? path.moveTo(at) : path.lineTo(at);
    gap = false;
  }
  painter.setPen(QPen(palette().color(color), 1.5));
  painter.drawPath(path);
}

void Plot::paintText(Qt::Alignment where, const QString& text) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(rect().adjusted(4, 2, -4, -2), where, text);
}

FpsPlot::FpsPlot(Controls& controls, QWidget* parent) : Plot(controls, tr("Frames a second"), parent) {
  setObjectName("fps-plot");
}

void FpsPlot::paintEvent(QPaintEvent*) {
  if (!program() || program()->fps.empty()) return paintNothing(tr("frames a second"));
  QPainter(this).fillRect(rect(), palette().base());
  const double top = topFor(program()->fps, 1);
  paintText(Qt::AlignLeft | Qt::AlignTop, tr("%1 frames/s").arg(top));
  paintLine(program()->fps, top, QPalette::Highlight);
}

NoisePlot::NoisePlot(Controls& controls, QWidget* parent)
    : Plot(controls, tr("Noise and passes of the image"), parent) {
  setObjectName("noise-plot");
  setToolTip(tr("Remaining noise of the image, and its passes (thin line)"));
  stateCame();
}

/// "43 %, 12 s left", of the image that the program waits for; empty: it waits for none.
QString NoisePlot::progress() const {
  using control::numberIn;
  const auto found = program()->state.find("progress");
  if (found == program()->state.end() || !found->is_object()) return {};
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const double share = numberIn<double>(*found, "share", nothing),
               left = numberIn<double>(*found, "secondsLeft", nothing);
  if (!(share >= 0 && share <= 1) || !std::isfinite(left)) return {};
  return tr("%1 %, %2 s left").arg(static_cast<int>(100 * share)).arg(left, 0, 'f', 0);
}

void NoisePlot::stateCame() {
  setVisible(program() &&
             (!progress().isEmpty() || std::any_of(program()->noise.begin(), program()->noise.end(),
                                                   [](double value) { return std::isfinite(value); })));
  QWidget::update();
}

void NoisePlot::paintEvent(QPaintEvent*) {
  if (!program()) return paintNothing(tr("noise"));
  QPainter(this).fillRect(rect(), palette().base());
  const double top = topFor(program()->noise, kMinNoise);
  paintLine(program()->passes, topFor(program()->passes, 1), QPalette::PlaceholderText);
  paintLine(program()->noise, top, QPalette::Highlight);
  paintText(Qt::AlignLeft | Qt::AlignTop, tr("noise, to %1").arg(top));
  const double noise = newestOf(program()->noise), passes = newestOf(program()->passes);
  if (std::isfinite(noise) && std::isfinite(passes))
    paintText(Qt::AlignRight | Qt::AlignTop, tr("%1 after %2 passes").arg(noise, 0, 'g', 3).arg(passes));
  paintText(Qt::AlignRight | Qt::AlignBottom, progress());
}

}  // namespace gluray::panel
