#include "model/finish_changes.h"

#include "model/controls.h"

#include <QEventLoop>
#include <QTimer>

namespace gluray::panel {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{10};

}  // namespace

void finishChanges(const Controls& controls, std::chrono::milliseconds most) {
  if (!controls.isChanging()) return;
  QEventLoop loop;
  QTimer look, end;
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    if (!controls.isChanging()) loop.quit();
  });
  QObject::connect(&end, &QTimer::timeout, &loop, &QEventLoop::quit);
  look.start(kBetweenLooks);
  end.start(most);
  loop.exec();
}

}  // namespace gluray::panel
