#include "view/saved_picture.h"

#include <nlohmann/json.hpp>

#include <QFile>
#include <QSaveFile>
#include <algorithm>
#include <utility>

namespace gluray::panel {
namespace {

constexpr int kEnd = 3000;  // milliseconds for a process to end

nlohmann::json jsonOf(const GlurayCamera& camera) {
  nlohmann::json json = {
      {"position", camera.position}, {"focal_point", camera.focalPoint}, {"up", camera.up}};
  if (camera.viewAngle == 0)
    json["parallel_scale"] = camera.parallelScale;
  else
    json["view_angle"] = camera.viewAngle;
  return json;
}

bool isCameraFile(const QByteArray& text) {
  const nlohmann::json json = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
  return json.is_object() && json.contains("cameras") && json.contains("saved_camera");
}

/// No option, whatever the file's name.
QString fileWord(const QString& file) { return file.startsWith('-') ? "./" + file : file; }

/// For a shell, where needed in quotes.
QString shellWord(const QString& word) {
  const QString plain = "%_-./+:@=,";
  const auto isPlain = [&](QChar c) {
    return (c.unicode() < 128 && c.isLetterOrNumber()) || plain.contains(c);
  };
  if (!word.isEmpty() && std::all_of(word.begin(), word.end(), isPlain)) return word;
  return "'" + QString(word).replace("'", "'\\''") + "'";
}

}  // namespace

QString cameraFileOf(const QString& picture) { return picture + ".camera.json"; }

QString writeCameraFile(const PictureWish& wish) {
  const QString name = cameraFileOf(wish.file);
  QFile old(name);
  if (old.exists() && (!old.open(QIODevice::ReadOnly) || !isCameraFile(old.readAll())))
    return QObject::tr("%1: it is no file of cameras, and stays as it is").arg(name);
  old.close();
  const nlohmann::json json = {{"saved_camera", jsonOf(wish.saved)},
                               {"cameras", nlohmann::json::array({jsonOf(*wish.camera)})}};
  QSaveFile file(name);
  const QByteArray text = QByteArray::fromStdString(json.dump(2) + "\n");
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) return {};
  return name + ": " + file.errorString();
}

QStringList renderWords(const PictureWish& wish) {
  QStringList words{"render", fileWord(wish.scene), fileWord(wish.file), "--size",
                    QString("%1x%2").arg(wish.size.width()).arg(wish.size.height())};
  if (wish.camera) words << "--path" << fileWord(cameraFileOf(wish.file));
  return words + wish.look;
}

QString commandLine(const QStringList& words) {
  QStringList quoted{"gluray"};
  for (const QString& word : words) quoted << shellWord(word);
  return quoted.join(' ');
}

PictureProcess::PictureProcess(QString gluray, QObject* parent)
    : QObject(parent), gluray_(std::move(gluray)) {
  connect(&process_, &QProcess::finished, this, &PictureProcess::finish);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) emit done(gluray_ + ": " + process_.errorString(), {});
  });
}

PictureProcess::~PictureProcess() {
  process_.disconnect(this);
  if (!isBusy()) return;
  process_.terminate();
  if (!process_.waitForFinished(kEnd)) process_.kill(), process_.waitForFinished(kEnd);
}

void PictureProcess::start(const PictureWish& wish) {
  if (wish.camera)
    if (const QString why = writeCameraFile(wish); !why.isEmpty()) return emit done(why, {});
  const QStringList words = renderWords(wish);
  command_ = commandLine(words);
  process_.start(gluray_, words);
}

void PictureProcess::finish() {
  const bool made = process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == 0;
  const QByteArray said = made ? process_.readAllStandardOutput() : process_.readAllStandardError();
  QString line = QString::fromUtf8(said).section('\n', 0, 0).trimmed();
  if (line.isEmpty()) line = tr("the picture was not made");
  emit done(line, made ? command_ : QString());
}

}  // namespace gluray::panel
