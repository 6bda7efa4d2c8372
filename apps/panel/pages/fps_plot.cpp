#include "pages/fps_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace gluray::panel {
namespace {

/// The least of 1, 2, 5, 10, 20 ... that is not below the value.
double roundedUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1.0))));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power) return step * power;
  return 10 * power;
}

}  // namespace

FpsPlot::FpsPlot(Controls& controls, QWidget* parent) : QWidget(parent), controls_(controls) {
  setMinimumHeight(fontMetrics().height() * 4);
  setAccessibleName(tr("Frames a second"));
  connect(&controls_, &Controls::stateChanged, this, [this] { QWidget::update(); });
  connect(&controls_, &Controls::chosenChanged, this, [this] { QWidget::update(); });
}

QSize FpsPlot::sizeHint() const { return {240, fontMetrics().height() * 6}; }

void FpsPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Program* program = controls_.shown();
  painter.fillRect(rect(), palette().base());
  painter.setPen(palette().color(QPalette::Text));
  if (!program || program->fps.empty()) {
    painter.drawText(rect(), Qt::AlignCenter, tr("frames a second"));
    return;
  }
  const std::deque<double>& fps = program->fps;
  constexpr double kHeadroom = 1.05;  // a steady line does not lie on the edge
  const double top = roundedUp(kHeadroom * *std::max_element(fps.begin(), fps.end()));
  const double room = height() - 2.0, step = width() / 599.0;
  QPainterPath path;
  for (size_t i = 0; i < fps.size(); ++i) {
    const QPointF at(width() - step * static_cast<double>(fps.size() - 1 - i), 1 + room * (1 - fps[i] / top));
    i ? path.lineTo(at) : path.moveTo(at);
  }
  painter.drawText(rect().adjusted(4, 2, -4, -2), Qt::AlignLeft | Qt::AlignTop, tr("%1 frames/s").arg(top));
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
  painter.drawPath(path);
}

}  // namespace gluray::panel
