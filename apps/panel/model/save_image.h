// Writes images as PNG files: into a temporary file, which then takes the name. Called on the GUI thread,
// works on one of Qt's pool.
#pragma once
#include <QImage>
#include <QObject>
#include <QString>
#include <functional>

namespace gluray::panel {

/// `then` is called on the GUI thread with an empty text, or why the file could not be written, unless
/// `receiver` has gone.
void saveImage(const QImage& image, const QString& file, QObject* receiver,
               std::function<void(const QString& why)> then);

}  // namespace gluray::panel
