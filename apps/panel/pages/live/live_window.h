// The live image in a window of its own: larger thumbnails, and the full size while the program stands
// still. GUI thread.
#pragma once
#include "model/still_image.h"

#include <QWidget>

class QLabel;

namespace gluray::panel {

class LiveView;

class LiveWindow : public QWidget {
  Q_OBJECT

 public:
  /// `owner`: the window that it goes with.
  LiveWindow(Controls& controls, QWidget* owner);
  ~LiveWindow() override;
  LiveView& view() { return *view_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showTitle();

  Controls& controls_;
  LiveView* view_;
  QLabel* line_;  // what the tools say
  StillImage still_;
};

}  // namespace gluray::panel
