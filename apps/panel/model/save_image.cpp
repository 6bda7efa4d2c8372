#include "model/save_image.h"

#include <QCoreApplication>
#include <QPointer>
#include <QSaveFile>
#include <QThreadPool>
#include <utility>

namespace gluray::panel {
namespace {

QString writePng(const QImage& image, const QString& path) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return path + ": " + file.errorString();
  if (!image.save(&file, "PNG") || !file.commit())
    return path + ": " +
           (file.errorString().isEmpty() ? QObject::tr("cannot be written") : file.errorString());
  return {};
}

}  // namespace

void saveImage(const QImage& image, const QString& file, QObject* receiver,
               std::function<void(const QString& why)> then) {
  QThreadPool::globalInstance()->start(
      [image, file, to = QPointer<QObject>(receiver), then = std::move(then)] {
        const QString why = writePng(image, file);
        // Through an object that lives as long as the GUI thread's loop: the receiver may go meanwhile.
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [to, then, why] {
              if (to) then(why);
            },
            Qt::QueuedConnection);
      });
}

}  // namespace gluray::panel
