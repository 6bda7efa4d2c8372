#include "pages/live/live_picture.h"

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

/// A word in a corner of the picture, readable over anything.
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

const QImage& FittedImage::scaled(const QImage& picture, const QSize& dots) {
  if (picture.cacheKey() == key_ && dots == dots_) return fitted_;
  key_ = picture.cacheKey(), dots_ = dots;
  const bool larger = picture.width() > dots.width() && picture.height() > dots.height();
  fitted_ = larger ? picture.scaled(dots, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : picture;
  return fitted_;
}

LivePicture::LivePicture(Controls& controls, QWidget* parent)
    : ShownWidget(controls, tr("Picture of the program's window"), parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(&controls, &Controls::thumbnailChanged, this, [this](int number) {
    if (program() && program()->number == number) QWidget::update();
  });
}

QSize LivePicture::sizeHint() const { return {256, 192}; }

void LivePicture::programChanged() { still_ = {}, other_ = {}, held_ = Held::nothing; }

void LivePicture::setStill(const QImage& picture) {
  still_ = picture;
  QWidget::update();
}

void LivePicture::compare(bool on, const QImage& picture) {
  compares_ = on, other_ = picture;
  setAccessibleDescription(on ? tr("Left of the divider: the real OpenGL") : QString());
  if (!on) unsetCursor();
  QWidget::update();
}

QImage LivePicture::picture() const {
  if (!still_.isNull()) return still_;
  return program() ? program()->thumbnail : QImage();
}

QRectF LivePicture::pictureRect() const {
  const QImage shown = picture();
  if (shown.isNull()) return {};
  const QSizeF size = QSizeF(shown.size()).scaled(QSizeF(rect().size()), Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

void LivePicture::paintEvent(QPaintEvent*) {
  const QRectF room = pictureRect();
  if (room.isEmpty()) return paintNothing(tr("no picture"));
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(room, fittedPicture_.scaled(picture(), dotsOf(room)));
  if (compares_) paintCompared(painter, room);
  if (!hasFocus()) return;
  painter.setPen(palette().color(QPalette::Highlight));
  painter.drawRect(room.adjusted(0, 0, -1, -1));
}

/// Of the screen.
QSize LivePicture::dotsOf(const QRectF& room) const {
  return (room.size() * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void LivePicture::paintCompared(QPainter& painter, const QRectF& room) {
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

bool LivePicture::isAtDivider(const QPointF& at) const {
  const QRectF room = pictureRect();
  return compares_ && !room.isEmpty() && std::abs(at.x() - room.left() - divider_ * room.width()) <= kGrip;
}

void LivePicture::setDivider(double share) {
  divider_ = std::clamp(share, 0.0, 1.0);
  QWidget::update();
}

PicturePoint LivePicture::pointAt(const QPointF& at) const {
  const QRectF room = pictureRect();
  const int width = std::max(1, static_cast<int>(std::lround(room.width()))),
            height = std::max(1, static_cast<int>(std::lround(room.height())));
  return {std::clamp(static_cast<int>(std::floor(at.x() - room.left())), 0, width - 1),
          std::clamp(static_cast<int>(std::floor(at.y() - room.top())), 0, height - 1), width, height};
}

void LivePicture::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || held_ != Held::nothing) return;
  if (isAtDivider(event->position())) {
    held_ = Held::divider;
  } else if (pictureRect().contains(event->position())) {
    held_ = Held::picture;
    emit pointed(pointAt(event->position()), Stage::press);
  }
}

void LivePicture::mouseMoveEvent(QMouseEvent* event) {
  const QRectF room = pictureRect();
  if (held_ == Held::divider && !room.isEmpty())
    setDivider((event->position().x() - room.left()) / room.width());
  else if (held_ == Held::picture && !room.isEmpty())
    emit pointed(pointAt(event->position()), Stage::move);
  else if (isAtDivider(event->position()))
    setCursor(Qt::SplitHCursor);
  else
    unsetCursor();
}

void LivePicture::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (std::exchange(held_, Held::nothing) == Held::picture)
    emit pointed(pointAt(event->position()), Stage::release);
}

void LivePicture::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !isAtDivider(event->position())) emit doubleClicked();
}

void LivePicture::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (!compares_ || step == 0) return ShownWidget::keyPressEvent(event);
  setDivider(divider_ + step * kDividerStep);
}

}  // namespace gluray::panel
