// The picture of a saved scene, and what mouse and keys do to its view. GUI thread.
#pragma once
#include "view/camera_moves.h"
#include "view/view_thread.h"

#include <QWidget>
#include <optional>

namespace gluray::panel {

class ViewWidget : public QWidget {
  Q_OBJECT

 public:
  /// `thread` must outlive it.
  ViewWidget(ViewThread& thread, QWidget* parent);

  /// The camera; none: the saved view.
  const std::optional<GlurayCamera>& camera() const { return camera_; }
  /// What is shown: the finished picture, the one so far, or a frame while the view moves.
  const QImage& image() const { return image_; }
  /// Pixels of the picture.
  QSize pixels() const;
  void setSettings(std::vector<std::string> settings);
  const std::vector<std::string>& settings() const { return settings_; }

  void reset();
  void fit();
  /// Degrees, about the middle of the surfaces.
  void turn(double right, double up);
  void zoom(double factor);

  QSize sizeHint() const override;

 signals:
  /// The view has another camera than before.
  void moved();
  /// The keys S and C.
  void saveWanted();
  void copyWanted();
  /// A picture of the present view has come.
  void progressed(const gluray::panel::ShownView& view);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void want();
  void take(const ShownView& view);
  ViewShape shape() const;
  GlurayCamera current() const { return camera_ ? *camera_ : thread_.facts().camera; }
  void look(const GlurayCamera& camera);
  bool movable() const { return thread_.facts().movable != 0; }

  ViewThread& thread_;
  std::optional<GlurayCamera> camera_;
  std::vector<std::string> settings_;
  QImage image_;
  uint64_t wanted_ = 0;  // the number of the last wish
  double pivot_[3];      // of turns
  QPointF last_;         // of the mouse
};

}  // namespace gluray::panel
