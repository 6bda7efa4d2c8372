#include "view/view_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace gluray::panel {
namespace {

constexpr double kTurn = 180;       // degrees for the width of the picture
constexpr double kKeyTurn = 5;      // degrees
constexpr double kKeyShift = 0.05;  // of the picture's height
constexpr double kNotch = 1.15;     // of the wheel
constexpr double kDragZoom = 4;     // powers of e for the height of the picture
constexpr int kLeast = 64;          // pixels a side

/// What the window showed.
QImage shownBy(const GlurayViewFacts& facts) {
  if (!facts.shown) return {};
  const QImage rows(reinterpret_cast<const uchar*>(facts.shown), facts.width, facts.height, facts.width * 4,
                    QImage::Format_RGBX8888);
  return rows.mirrored();
}

}  // namespace

ViewWidget::ViewWidget(ViewThread& thread, QWidget* parent)
    : QWidget(parent), thread_(thread), image_(shownBy(thread.facts())) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(kLeast, kLeast);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Picture of the scene"));
  setToolTip(movable()
                 ? tr("Left: turn; right or wheel: zoom; middle: shift; double click: look at a point.\n"
                      "Arrows turn, with Shift they shift; + and - zoom; R: as saved; F: fit")
                 : tr("This view cannot be moved: its camera is not known"));
  std::copy_n(thread.facts().middle, 3, pivot_);
  connect(&thread_, &ViewThread::shown, this, &ViewWidget::take);
  connect(&thread_, &ViewThread::pointFound, this, [this](double x, double y, double z) {
    const double point[3] = {x, y, z};
    std::copy_n(point, 3, pivot_);
    look(centredOn(current(), point));
  });
}

QSize ViewWidget::sizeHint() const {
  return (QSizeF(thread_.facts().width, thread_.facts().height) / devicePixelRatioF()).toSize();
}

QSize ViewWidget::pixels() const {
  const QSizeF size = QSizeF(this->size()) * devicePixelRatioF();
  return {static_cast<int>(std::lround(size.width())), static_cast<int>(std::lround(size.height()))};
}

ViewShape ViewWidget::shape() const {
  const QSize size = pixels();
  return {thread_.facts().width, thread_.facts().height, size.width(), size.height()};
}

void ViewWidget::want() {
  if (isVisible()) wanted_ = thread_.want({pixels(), camera_, settings_});
}

void ViewWidget::setSettings(std::vector<std::string> settings) {
  settings_ = std::move(settings);
  want();
}

/// Frames of a view that is still being turned are shown, too: otherwise none would be while the mouse moves.
void ViewWidget::take(const ShownView& view) {
  if (view.number != wanted_ && !view.moving) return;
  if (!view.image.isNull()) {
    image_ = view.image;
    update();
  }
  emit progressed(view);
}

void ViewWidget::look(const GlurayCamera& camera) {
  if (!movable()) return;
  camera_.reset();
  if (!areEqual(camera, thread_.facts().camera)) camera_ = camera;
  want();
  emit moved();
}

void ViewWidget::reset() {
  camera_.reset();
  std::copy_n(thread_.facts().middle, 3, pivot_);
  want();
  emit moved();
}

void ViewWidget::fit() {
  if (!movable()) return;
  std::copy_n(thread_.facts().middle, 3, pivot_);
  look(fitted(current(), shape(), thread_.facts().middle, thread_.facts().radius));
}

void ViewWidget::turn(double right, double up) {
  if (movable()) look(turned(current(), pivot_, right, up));
}

void ViewWidget::zoom(double factor) {
  if (movable()) look(zoomed(current(), factor));
}

void ViewWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  const bool same = image_.size() == pixels();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, !same);
  if (!image_.isNull()) painter.drawImage(QRectF(rect()), image_);
}

void ViewWidget::resizeEvent(QResizeEvent*) { want(); }

void ViewWidget::showEvent(QShowEvent*) { want(); }

void ViewWidget::mousePressEvent(QMouseEvent* event) { last_ = event->position(); }

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_;
  last_ = event->position();
  if (!movable() || by.isNull()) return;
  const bool shifts = event->buttons() & Qt::MiddleButton ||
                      (event->buttons() & Qt::LeftButton && event->modifiers() & Qt::ShiftModifier);
  if (shifts)
    look(shifted(current(), shape(), by.x() * devicePixelRatioF(), by.y() * devicePixelRatioF()));
  else if (event->buttons() & Qt::LeftButton)
    turn(by.x() * kTurn / std::max(width(), 1), by.y() * -kTurn / std::max(height(), 1));
  else if (event->buttons() & Qt::RightButton)
    zoom(std::exp(-by.y() / std::max(height(), 1) * kDragZoom));
}

void ViewWidget::mouseReleaseEvent(QMouseEvent*) {}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !movable()) return;
  const QPointF at = event->position() * devicePixelRatioF();
  wanted_ = thread_.findPoint(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kNotch, event->angleDelta().y() / 120.0));
  event->accept();
}

void ViewWidget::keyPressEvent(QKeyEvent* event) {
  const bool shifts = event->modifiers() & Qt::ShiftModifier;
  const double step = kKeyShift * pixels().height();
  const auto move = [&](double right, double down) {
    if (!movable()) return;
    if (shifts)
      look(shifted(current(), shape(), right * step, down * step));
    else
      turn(right * kKeyTurn, -down * kKeyTurn);
  };
  switch (event->key()) {
    case Qt::Key_Left: return move(-1, 0);
    case Qt::Key_Right: return move(1, 0);
    case Qt::Key_Up: return move(0, -1);
    case Qt::Key_Down: return move(0, 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoom(kNotch);
    case Qt::Key_Minus: return zoom(1 / kNotch);
    case Qt::Key_R: return reset();
    case Qt::Key_F: return fit();
    case Qt::Key_C: return emit copyWanted();
    case Qt::Key_S: return emit saveWanted();
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace gluray::panel
