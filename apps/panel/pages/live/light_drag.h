// Puts the key light's highlight where the user drags over the image: the call `highlight` says which
// direction of light that takes. GUI thread.
#pragma once
#include "model/controls.h"
#include "model/movement.h"
#include "pages/live/live_image.h"

#include <QObject>
#include <optional>

namespace gluray::panel {

class LightDrag : public QObject {
  Q_OBJECT

 public:
  LightDrag(Controls& controls, QObject* parent);
  void point(const ImagePoint& at, LiveImage::Stage stage);

 signals:
  void said(const QString& line);

 private:
  void ask();
  void receiveAnswer(const CallAnswer& answer, uint64_t drag);
  void finish();

  Controls& controls_;
  Movement movement_;
  std::optional<ImagePoint> next_;  // the newest place that was not asked for
  bool underWay_ = false;           // a call; there is one at a time
  bool released_ = true;
  uint64_t drag_ = 0;  // counts them
  int program_ = 0;
};

}  // namespace gluray::panel
