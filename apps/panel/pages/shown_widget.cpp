#include "pages/shown_widget.h"

#include <QPainter>
#include <utility>

namespace gluray::panel {

ShownWidget::ShownWidget(Controls& controls, const QString& name, QWidget* parent)
    : QWidget(parent), controls_(controls) {
  setAccessibleName(name);
  setMinimumHeight(fontMetrics().height() * 4);
  const auto show = [this] {
    const int number = program() ? program()->number : 0;
    if (std::exchange(shown_, number) != number) programChanged();
    QWidget::update();
  };
  connect(&controls_, &Controls::chosenChanged, this, show);
  connect(&controls_, &Controls::programsChanged, this, show);
}

void ShownWidget::paintNothing(const QString& text) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, text);
}

}  // namespace gluray::panel
