// The lights that shine in the shown program, as the call `lights` says. GUI thread.
#pragma once
#include "model/poll.h"

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace gluray::panel {

class LightList : public QWidget {
  Q_OBJECT

 public:
  LightList(Controls& controls, QWidget* parent);
  QSize sizeHint() const override;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void receiveAnswer(const CallAnswer& answer);
  void say(const QString& line);

  Poll poll_;
  QLabel* message_;
  QTreeWidget* lights_;
};

}  // namespace gluray::panel
