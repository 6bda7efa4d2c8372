#include "pictures/cameras/paraview_cameras.h"

#include "base/number_text.h"
#include "pictures/cameras/xml_elements.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace gluray::launcher {
namespace {

[[noreturn]] void refuseFile(const std::string& what) { throw std::runtime_error(what); }

double xmlNumber(const std::string& text) {
  double value = 0;
  if (!readNumber(text, value) || !std::isfinite(value)) refuseFile("'" + text + "' is no number");
  return value;
}

/// The values of a proxy's property. Throws if it has not so many.
std::vector<double> propertyValues(const XmlElement& proxy, const char* property, size_t count) {
  const XmlElement* const found = proxy.child("Property", "name", property);
  std::vector<double> values;
  if (found)
    for (const XmlElement& element : found->children)
      if (element.name == "Element") values.push_back(xmlNumber(element["value"]));
  if (values.size() != count) refuseFile(std::string("it has no ") + property);
  return values;
}

double propertyValue(const XmlElement& proxy, const char* property) {
  return propertyValues(proxy, property, 1)[0];
}

double propertyOr(const XmlElement& proxy, const char* property, double otherwise) {
  return proxy.child("Property", "name", property) ? propertyValue(proxy, property) : otherwise;
}

Vector3 propertyVector(const XmlElement& proxy, const char* property) {
  const std::vector<double> v = propertyValues(proxy, property, 3);
  return {v[0], v[1], v[2]};
}

PathCamera cameraOfView(const XmlElement& view) {
  PathCamera camera{propertyVector(view, "CameraPosition"), propertyVector(view, "CameraFocalPoint"),
                    propertyVector(view, "CameraViewUp"), propertyValue(view, "CameraViewAngle"),
                    propertyOr(view, "CameraParallelScale", 1)};
  if (propertyOr(view, "CameraParallelProjection", 0) != 0) camera.viewAngle = 0;
  return camera;
}

/// The numbers of the proxies that a property names.
std::vector<std::string> proxiesIn(const XmlElement& proxy, const char* property) {
  std::vector<std::string> numbers;
  if (const XmlElement* const found = proxy.child("Property", "name", property))
    for (const XmlElement& element : found->children)
      if (element.name == "Proxy") numbers.push_back(element["value"]);
  return numbers;
}

const XmlElement& proxyOf(const XmlElement& state, const std::string& id) {
  const XmlElement* const found = state.child("Proxy", "id", id);
  if (!found) refuseFile("it lacks a part, proxy " + id);
  return *found;
}

/// The one animation of a camera that is played.
const XmlElement& cueOf(const XmlElement& state) {
  const XmlElement* cue = nullptr;
  for (const XmlElement& proxy : state.children) {
    if (proxy.name != "Proxy" || proxy["type"] != "CameraAnimationCue" ||
        propertyOr(proxy, "Enabled", 1) == 0)
      continue;
    if (cue) refuseFile("it has camera animations of several views: delete all but one");
    cue = &proxy;
  }
  if (!cue) refuseFile("it has no camera animation");
  if (const double mode = propertyValue(*cue, "Mode"); mode != 0)
    refuseFile(mode == 1
                   ? "its camera animation is a path or an orbit, which is not supported: use ParaView's "
                     "\"Interpolate camera locations\""
                   : "its camera animation follows data, which is not supported");
  if (propertyOr(*cue, "TimeMode", 0) != 0 || propertyOr(*cue, "StartTime", 0) != 0 ||
      propertyOr(*cue, "EndTime", 1) != 1)
    refuseFile("its camera animation does not last from the first frame to the last, which is not supported");
  return *cue;
}

const XmlElement& animationOf(const XmlElement& state) {
  const XmlElement* const scene = state.child("Proxy", "type", "AnimationScene");
  if (!scene) refuseFile("it has no animation");
  return *scene;
}

}  // namespace

PathCamera readPvcc(std::string_view text) {
  const XmlElement outermost = readXml(text);
  const XmlElement* const view = outermost.child("Proxy", "group", "views");
  if (outermost.name != "PVCameraConfiguration" || !view) refuseFile("it is no camera of ParaView");
  return cameraOfView(*view);
}

CameraPath readPvsm(std::string_view text) {
  const XmlElement outermost = readXml(text);
  const XmlElement* state = outermost.name == "ServerManagerState" ? &outermost : nullptr;
  for (const XmlElement& child : outermost.children)
    if (child.name == "ServerManagerState") state = &child;
  if (!state) refuseFile("it is no state of ParaView");
  const XmlElement& cue = cueOf(*state);
  const std::vector<std::string> views = proxiesIn(cue, "AnimatedProxy");
  if (views.size() != 1) refuseFile("its camera animation has no view");
  CameraPath path;
  path.saved.push_back(cameraOfView(proxyOf(*state, views[0])));
  for (const std::string& id : proxiesIn(cue, "KeyFrames")) {
    const XmlElement& key = proxyOf(*state, id);
    PathCamera camera{propertyVector(key, "Position"), propertyVector(key, "FocalPoint"),
                      propertyVector(key, "ViewUp"), propertyValue(key, "ViewAngle"),
                      propertyValue(key, "ParallelScale")};
    if (path.saved[0].viewAngle == 0) camera.viewAngle = 0;
    path.keys.push_back({propertyValue(key, "KeyTime"), camera});
  }
  std::sort(path.keys.begin(), path.keys.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  for (size_t i = 1; i < path.keys.size(); ++i)
    if (path.keys[i - 1].time == path.keys[i].time) refuseFile("two of its key frames have the same time");
  if (path.keys.size() < 2) refuseFile("its camera animation has fewer than two key frames");
  // Versions before 5.11 have splines alone.
  path.between =
      propertyOr(cue, "Interpolation", 1) == 0 ? CameraPath::Between::linear : CameraPath::Between::spline;
  path.upward = CameraPath::Upward::coordinates;
  path.begin = 0, path.end = 1;
  path.pictures =
      static_cast<int>(std::clamp(propertyOr(animationOf(*state), "NumberOfFrames", 0), 0.0, 1e5));
  return path;
}

}  // namespace gluray::launcher
