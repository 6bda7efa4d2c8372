#include "pages/light/light_sphere.h"

#include "model/controls.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace gluray::panel {
namespace {

constexpr double kKeyStep = 5;  // degrees
constexpr double kShininess = 40;
constexpr double kAmbient = 0.16;
constexpr QRgb kBall = 0xffc8b8a4;  // as clay

/// What screen readers say of it.
class SphereAccess : public QAccessibleWidget {
 public:
  explicit SphereAccess(LightSphere* sphere) : QAccessibleWidget(sphere, QAccessible::Dial) {}
  QString text(QAccessible::Text text) const override {
    return text == QAccessible::Value ? static_cast<LightSphere*>(object())->valueText()
                                      : QAccessibleWidget::text(text);
  }
};

QAccessibleInterface* sphereAccess(const QString&, QObject* object) {
  auto* sphere = qobject_cast<LightSphere*>(object);
  return sphere ? new SphereAccess(sphere) : nullptr;
}

int channel(int color, double light, double shine) {
  return static_cast<int>(std::clamp(color * light + 255 * shine, 0.0, 255.0));
}

/// A ball of that many pixels, lit from there.
QImage ballImage(int side, const LightDirection& direction) {
  QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  const LightVector light = vectorOf(direction);
  const double radius = side / 2.0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / radius - 1, y = 1 - (row + 0.5) / radius;
      const double rest = 1 - x * x - y * y;
      if (rest < 0) continue;
      const double z = std::sqrt(rest);
      const double cosine = x * light.x + y * light.y + z * light.z;
      const double half = std::sqrt(light.x * light.x + light.y * light.y + (light.z + 1) * (light.z + 1));
      const double shine = half > 1e-6 ? std::pow(std::max(0.0, (cosine + z) / half), kShininess) * 0.6 : 0;
      const double lit = kAmbient + (1 - kAmbient) * std::max(0.0, cosine);
      const double cover =
          std::clamp((1 - std::sqrt(x * x + y * y)) * radius, 0.0, 1.0);  // of the rim's pixels
      const QRgb color = qRgba(channel(qRed(kBall), lit, shine), channel(qGreen(kBall), lit, shine),
                               channel(qBlue(kBall), lit, shine), static_cast<int>(255 * cover));
      image.setPixel(column, row, qPremultiply(color));
    }
  return image;
}

double numberOf(const nlohmann::json& value) { return value.is_number() ? value.get<double>() : 0; }

}  // namespace

LightSphere::LightSphere(Controls& controls, QWidget* parent)
    : QWidget(parent), controls_(controls), movement_(controls, this) {
  static const bool installed = (QAccessible::installFactory(sphereAccess), true);
  static_cast<void>(installed);
  setObjectName("light-sphere");
  setAccessibleName(tr("Direction of the key light"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
  update();
}

QSize LightSphere::sizeHint() const {
  const int side = fontMetrics().height() * 8;
  return {side, side};
}

QString LightSphere::valueText() const {
  return tr("azimuth %1 degrees, elevation %2 degrees").arg(direction_.azimuth).arg(direction_.elevation);
}

void LightSphere::update() {
  setEnabled(controls_.shown());
  if (!movement_.goesOn())
    direction_ = {numberOf(controls_.value("lights.azimuth").value),
                  numberOf(controls_.value("lights.elevation").value)};
  setToolTip(tr("Drag the highlight, or press the arrow keys: %1").arg(valueText()));
  setAccessibleDescription(valueText());
  QWidget::update();
}

QRectF LightSphere::ball() const {
  const double side = std::min(width(), height()) - 6.0;
  return {(width() - side) / 2, (height() - side) / 2, side, side};
}

void LightSphere::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF room = ball();
  const int side = std::max(1, static_cast<int>(room.width() * devicePixelRatioF()));
  if (!isEnabled()) painter.setOpacity(0.35);
  painter.drawImage(room, ballImage(side, direction_));
  const QPointF at = highlightAt(direction_);
  const QPointF spot = room.center() + QPointF(at.x(), -at.y()) * room.width() / 2;
  painter.setPen(QPen(Qt::black, 2.5));
  painter.drawEllipse(spot, 4.5, 4.5);
  painter.setPen(QPen(Qt::white, 1.2));
  painter.drawEllipse(spot, 4.5, 4.5);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.drawEllipse(room.adjusted(-2, -2, 2, 2));
}

void LightSphere::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragged_ = true;
  drag(event->position(), true);
}

void LightSphere::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_) drag(event->position(), true);
}

void LightSphere::mouseReleaseEvent(QMouseEvent* event) {
  if (!dragged_ || event->button() != Qt::LeftButton) return;
  dragged_ = false;
  drag(event->position(), false);
}

void LightSphere::drag(const QPointF& at, bool more) {
  const QRectF room = ball();
  const QPointF from = (at - room.center()) / (room.width() / 2);
  turnTo(directionFor({from.x(), -from.y()}), more);
}

void LightSphere::keyPressEvent(QKeyEvent* event) {
  LightDirection next = direction_;
  switch (event->key()) {
    case Qt::Key_Left: next.azimuth -= kKeyStep; break;
    case Qt::Key_Right: next.azimuth += kKeyStep; break;
    case Qt::Key_Up: next.elevation += kKeyStep; break;
    case Qt::Key_Down: next.elevation -= kKeyStep; break;
    default: return QWidget::keyPressEvent(event);
  }
  turnTo({std::remainder(next.azimuth, 360), std::clamp(next.elevation, -90.0, 90.0)}, false);
}

void LightSphere::turnTo(LightDirection direction, bool more) {
  const nlohmann::json values = lightValues(controls_, direction);
  if (const QString line = lineAboutRig(controls_); !line.isEmpty()) emit said(line);
  direction_ = {values["lights.azimuth"], values["lights.elevation"]};
  movement_.send(values, more);
  setAccessibleDescription(valueText());
  QAccessibleValueChangeEvent changed(this, valueText());
  QAccessible::updateAccessibility(&changed);
  QWidget::update();
}

}  // namespace gluray::panel
