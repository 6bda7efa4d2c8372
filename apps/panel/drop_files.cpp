#include "drop_files.h"

#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>

namespace gluray::panel {
namespace {

constexpr qint64 kMaxTomlBytes = 1 << 20;  // bytes that are read

bool hasTable(const QString& text, const QString& name) {
  const QRegularExpression table("^\\s*\\[\\[\\s*" + name + "\\s*\\]\\]",
                                 QRegularExpression::MultilineOption);
  return table.match(text).hasMatch();
}

DropMeaning meaningOfToml(const QString& path, const QString& name) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {nullptr, name + ": " + file.errorString()};
  const QString text = QString::fromUtf8(file.read(kMaxTomlBytes));
  const bool rules = hasTable(text, "rule"), lights = hasTable(text, "light");
  if (rules == lights)
    return {
        nullptr,
        QObject::tr("%1 is neither a file of materials ([[rule]]) nor one of lights ([[light]])").arg(name)};
  return {{{rules ? "material.file" : "lights.file", path.toStdString()}}, {}};
}

}  // namespace

DropMeaning meaningOf(const QString& path) {
  const QFileInfo info(path);
  const QString name = info.fileName(), suffix = info.suffix().toLower();
  if (!info.isFile()) return {nullptr, QObject::tr("%1 is no file").arg(name.isEmpty() ? path : name)};
  const QString whole = info.absoluteFilePath();
  if (suffix == "hdr" || suffix == "exr")
    return {{{"environment", "image"}, {"environment.file", whole.toStdString()}}, {}};
  if (suffix == "toml") return meaningOfToml(whole, name);
  return {
      nullptr,
      QObject::tr("%1: drop an environment (.hdr, .exr), or a .toml file of materials or lights").arg(name)};
}

}  // namespace gluray::panel
