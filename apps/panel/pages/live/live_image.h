// The image that a window of the shown program shows, and where the user points in it. GUI thread.
#pragma once
#include "pages/shown_widget.h"

#include <QImage>

namespace gluray::panel {

/// An image in the size in which it is painted: large ones are scaled once, and not whenever they are
/// painted.
class FittedImage {
 public:
  const QImage& scaled(const QImage& image, const QSize& dots);

 private:
  QImage fitted_;
  qint64 key_ = 0;
  QSize dots_;
};

/// A place in the image, counted from its left and top in an image of that size: what calls such as `pick`
/// take.
struct ImagePoint {
  int x = 0, y = 0, width = 0, height = 0;
};

class LiveImage : public ShownWidget {
  Q_OBJECT

 public:
  enum class Stage { press, move, release };

  LiveImage(Controls& controls, QWidget* parent);
  QSize sizeHint() const override;

  /// An image that is shown in place of the thumbnail, such as one in full size; null: none.
  void setStill(const QImage& image);
  /// Compares: `image`, the real OpenGL's, is shown left of a divider, which can be dragged. Null while
  /// there is none yet.
  void compare(bool on, const QImage& image = {});
  bool compares() const { return compares_; }
  /// Where the divider is: a share of the image's width.
  double divider() const { return divider_; }
  /// Where the image is painted; empty: there is none.
  QRectF imageRect() const;

 signals:
  /// The left button, over the image; moves also outside of it, then at its edge.
  void pointed(const gluray::panel::ImagePoint& at, gluray::panel::LiveImage::Stage stage);
  void doubleClicked();

 protected:
  void programChanged() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QImage image() const;
  bool isAtDivider(const QPointF& at) const;
  void setDivider(double share);
  ImagePoint pointAt(const QPointF& at) const;
  QSize dotsOf(const QRectF& room) const;
  void paintCompared(QPainter& painter, const QRectF& room);

  QImage still_, other_;
  FittedImage fittedImage_, fittedOther_;
  bool compares_ = false;
  double divider_ = 0.5;
  enum class Held { nothing, image, divider } held_ = Held::nothing;
};

}  // namespace gluray::panel
