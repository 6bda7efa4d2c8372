#include "pages/live/live_image.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gluray::panel {
namespace {

constexpr double kGrip = 6;            // pixels beside the divider that belong to it
constexpr double kDividerStep = 0.02;  // of a key

/// A word in a corner of the image, readable over anything.
void paintLabel(QPainter& painter, const QRectF& room, Qt::Alignment side, const QString& text) {
  const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, text) + QSize(8, 4);
  if (size.width() + 4 > room.width()) return;
  const double x = side & Qt::AlignLeft ? room.left() + 4 : room.right() - 4 - size.width();
  const QRectF box(QPointF(x, room.top() + 4), size);
  painter.fillRect(box, QColor(0, 0, 0, 160));
  painter.setPen(Qt::white);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

const QImage& FittedImage::scaled(const QImage& image, const QSize& dots) {
  if (image.cacheKey() == key_ && dots == dots_) return fitted_;
  key_ = image.cacheKey(), dots_ = dots;
  const bool larger = image.width() > dots.width() && image.height() > dots.height();
  fitted_ = larger ? image.scaled(dots, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : image;
  return fitted_;
}

LiveImage::LiveImage(Controls& controls, QWidget* parent)
    : ShownWidget(controls, tr("Image of the program's window"), parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(&controls, &Controls::thumbnailChanged, this, [this](int number) {
    if (program() && program()->number == number) QWidget::update();
  });
}

QSize LiveImage::sizeHint() const { return {256, 192}; }

void LiveImage::programChanged() { still_ = {}, other_ = {}, held_ = Held::nothing; }

void LiveImage::setStill(const QImage& image) {
  still_ = image;
  QWidget::update();
}

void LiveImage::compare(bool on, const QImage& image) {
  compares_ = on, other_ = image;
  setAccessibleDescription(on ? tr("Left of the divider: the real OpenGL") : QString());
  if (!on) unsetCursor();
  QWidget::update();
}

QImage LiveImage::image() const {
  if (!still_.isNull()) return still_;
  return program() ? program()->thumbnail : QImage();
}

QRectF LiveImage::imageRect() const {
  const QImage shown = image();
  if (shown.isNull()) return {};
  const QSizeF size = QSizeF(shown.size()).scaled(QSizeF(rect().size()), Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

void LiveImage::paintEvent(QPaintEvent*) {
  const QRectF room = imageRect();
  if (room.isEmpty()) return paintNothing(tr("no image"));
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(room, fittedImage_.scaled(image(), dotsOf(room)));
  if (compares_) paintCompared(painter, room);
  if (!hasFocus()) return;
  painter.setPen(palette().color(QPalette::Highlight));
  painter.drawRect(room.adjusted(0, 0, -1, -1));
}

/// Of the screen.
QSize LiveImage::dotsOf(const QRectF& room) const {
  return (room.size() * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void LiveImage::paintCompared(QPainter& painter, const QRectF& room) {
  const double x = room.left() + divider_ * room.width();
  const QRectF left(room.topLeft(), QPointF(x, room.bottom())),
      right(QPointF(x, room.top()), room.bottomRight());
  if (!other_.isNull()) {
    painter.save();
    painter.setClipRect(left);
    painter.drawImage(room, fittedOther_.scaled(other_, dotsOf(room)));
    painter.restore();
  }
  painter.fillRect(QRectF(x - 1.5, room.top(), 3, room.height()), Qt::black);
  painter.fillRect(QRectF(x - 0.5, room.top(), 1, room.height()), Qt::white);
  paintLabel(painter, left, Qt::AlignLeft, other_.isNull() ? tr("OpenGL...") : tr("OpenGL"));
  paintLabel(painter, right, Qt::AlignRight, tr("GLuRay"));
}

bool LiveImage::isAtDivider(const QPointF& at) const {
  const QRectF room = imageRect();
  return compares_ && !room.isEmpty() && std::abs(at.x() - room.left() - divider_ * room.width()) <= kGrip;
}

void LiveImage::setDivider(double share) {
  divider_ = std::clamp(share, 0.0, 1.0);
  QWidget::update();
}

ImagePoint LiveImage::pointAt(const QPointF& at) const {
  const QRectF room = imageRect();
  const int width = std::max(1, static_cast<int>(std::lround(room.width()))),
            height = std::max(1, static_cast<int>(std::lround(room.height())));
  return {std::clamp(static_cast<int>(std::floor(at.x() - room.left())), 0, width - 1),
          std::clamp(static_cast<int>(std::floor(at.y() - room.top())), 0, height - 1), width, height};
}

void LiveImage::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || held_ != Held::nothing) return;
  if (isAtDivider(event->position())) {
    held_ = Held::divider;
  } else if (imageRect().contains(event->position())) {
    held_ = Held::image;
    emit pointed(pointAt(event->position()), Stage::press);
  }
}

void LiveImage::mouseMoveEvent(QMouseEvent* event) {
  const QRectF room = imageRect();
  if (held_ == Held::divider && !room.isEmpty())
    setDivider((event->position().x() - room.left()) / room.width());
  else if (held_ == Held::image && !room.isEmpty())
    emit pointed(pointAt(event->position()), Stage::move);
  else if (isAtDivider(event->position()))
    setCursor(Qt::SplitHCursor);
  else
    unsetCursor();
}

void LiveImage::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (std::exchange(held_, Held::nothing) == Held::image)
    emit pointed(pointAt(event->position()), Stage::release);
}

void LiveImage::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !isAtDivider(event->position())) emit doubleClicked();
}

void LiveImage::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (!compares_ || step == 0) return ShownWidget::keyPressEvent(event);
  setDivider(divider_ + step * kDividerStep);
}

}  // namespace gluray::panel
