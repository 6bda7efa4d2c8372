#include "pages/live_picture.h"

#include <QPainter>

namespace gluray::panel {

LivePicture::LivePicture(Controls& controls, QWidget* parent) : QWidget(parent), controls_(controls) {
  setMinimumHeight(fontMetrics().height() * 4);
  setAccessibleName(tr("Picture of the program's window"));
  connect(&controls_, &Controls::thumbnailChanged, this, [this](int program) {
    if (const Program* shown = controls_.shown(); shown && shown->number == program) QWidget::update();
  });
  connect(&controls_, &Controls::chosenChanged, this, [this] { QWidget::update(); });
  connect(&controls_, &Controls::programsChanged, this, [this] { QWidget::update(); });
}

QSize LivePicture::sizeHint() const { return {256, 192}; }

void LivePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Program* program = controls_.shown();
  if (!program || program->thumbnail.isNull()) {
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect(), Qt::AlignCenter, tr("no picture"));
    return;
  }
  const QSizeF size = QSizeF(program->thumbnail.size()).scaled(QSizeF(rect().size()), Qt::KeepAspectRatio);
  const QPointF corner((width() - size.width()) / 2, (height() - size.height()) / 2);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(corner, size), program->thumbnail);
}

}  // namespace gluray::panel
