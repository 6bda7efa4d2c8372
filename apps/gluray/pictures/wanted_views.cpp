#include "pictures/wanted_views.h"

#include "base/hash.h"
#include "pictures/cameras/camera_files.h"

#include <algorithm>
#include <cstdio>

namespace gluray::launcher {
namespace {

GlurayCamera cameraFor(const PathCamera& from) {
  GlurayCamera to{};
  std::copy_n(from.position.begin(), 3, to.position);
  std::copy_n(from.focalPoint.begin(), 3, to.focalPoint);
  std::copy_n(from.up.begin(), 3, to.up);
  to.viewAngle = from.viewAngle, to.parallelScale = from.parallelScale;
  return to;
}

}  // namespace

std::string WantedViews::hash() const {
  if (cameras.empty()) return "";
  Hash128 hash = hashBytes(cameras.data(), cameras.size() * sizeof(GlurayCamera));
  hash = hashBytes(saved.data(), saved.size() * sizeof(GlurayCamera), hash);
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high),
                static_cast<unsigned long long>(hash.low));
  return text;
}

WantedViews wantedViews(const PictureOptions& options) {
  WantedViews views;
  if (options.path.empty()) {
    views.numbered = options.turntable > 0;
    views.pictures = std::max(options.turntable, 1);
    return views;
  }
  const CameraPath path = readCameraPath(options.path);
  for (const PathCamera& camera : path.cameras(options.frames)) views.cameras.push_back(cameraFor(camera));
  views.pictures = static_cast<int>(views.cameras.size());
  views.numbered = views.pictures > 1;
  const bool said = !options.savedCamera.empty();
  if (said)
    views.saved.push_back(cameraFor(readCamera(options.savedCamera)));
  else
    for (const PathCamera& camera : path.saved) views.saved.push_back(cameraFor(camera));
  // A state file has the view's camera of when the state was saved, not the scene.
  views.stated = said || (!path.saved.empty() && path.upward == CameraPath::Upward::arc);
  if (!views.stated)
    for (const KeyCamera& key : path.keys) views.saved.push_back(cameraFor(key.camera));
  return views;
}

}  // namespace gluray::launcher
