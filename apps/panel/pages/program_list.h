// The programs that run under GLuRay, with their live figures. GUI thread.
#pragma once
#include "model/controls.h"

#include <QTreeWidget>

namespace gluray::panel {

class ProgramList : public QTreeWidget {
  Q_OBJECT

 public:
  ProgramList(Controls& controls, QWidget* parent);

 private:
  void fill();
  void mark();
  void showState(int program);
  void showThumbnail(int program);

  Controls& controls_;
};

}  // namespace gluray::panel
