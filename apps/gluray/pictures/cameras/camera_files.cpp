#include "pictures/cameras/camera_files.h"

#include "base/files.h"
#include "base/printable.h"
#include "pictures/cameras/paraview_cameras.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

constexpr size_t kMostBytes = size_t{64} << 20;
constexpr size_t kMostCameras = 100000;

[[noreturn]] void failJson(const std::string& what) { throw std::runtime_error(what); }

double jsonNumber(const json& from, const char* name) {
  if (!from.is_number() || !std::isfinite(from.get<double>())) failJson(std::string(name) + ": use a number");
  return from.get<double>();
}

Vector3 jsonVector(const json& camera, const char* name) {
  const auto found = camera.find(name);
  if (found == camera.end()) failJson(std::string("it has no ") + name);
  if (!found->is_array() || found->size() != 3) failJson(std::string(name) + ": use three numbers");
  return {jsonNumber((*found)[0], name), jsonNumber((*found)[1], name), jsonNumber((*found)[2], name)};
}

void refuseOthers(const json& object, std::initializer_list<const char*> known) {
  for (const auto& [name, value] : object.items())
    if (std::find_if(known.begin(), known.end(), [&](const char* k) { return name == k; }) == known.end())
      failJson("unknown member \"" + name + "\"");
}

PathCamera cameraIn(const json& from) {
  if (!from.is_object()) failJson("use an object");
  refuseOthers(from, {"position", "focal_point", "up", "view_angle", "parallel_scale", "time", "frame"});
  PathCamera camera{jsonVector(from, "position"), jsonVector(from, "focal_point"), jsonVector(from, "up"), 0,
                    1};
  if (from.contains("view_angle") == from.contains("parallel_scale"))
    failJson("it needs view_angle, or for a parallel projection parallel_scale");
  if (from.contains("view_angle")) {
    camera.viewAngle = jsonNumber(from["view_angle"], "view_angle");
    if (!(camera.viewAngle > 0 && camera.viewAngle < 180))
      failJson("view_angle: use degrees between 0 and 180");
  } else {
    camera.parallelScale = jsonNumber(from["parallel_scale"], "parallel_scale");
    if (!(camera.parallelScale > 0)) failJson("parallel_scale: use a number above 0");
  }
  return camera;
}

/// Key cameras with times, or numbers of pictures, or one after the other.
std::vector<KeyCamera> keysIn(const json& cameras, const char*& clock) {
  if (!cameras.is_array() || cameras.empty()) failJson("it has no cameras");
  if (cameras.size() > kMostCameras) failJson("it has more than 100000 cameras");
  std::vector<KeyCamera> keys;
  clock = cameras[0].contains("time") ? "time" : cameras[0].contains("frame") ? "frame" : nullptr;
  for (const json& one : cameras) try {
      const bool timed = one.contains("time"), counted = one.contains("frame");
      if ((timed && counted) || (clock ? !one.contains(clock) : timed || counted))
        failJson("give all cameras a time, or all a frame, or none");
      const double time = clock ? jsonNumber(one[clock], clock) : static_cast<double>(keys.size());
      if (counted && time != std::floor(time)) failJson("frame: use a whole number");
      if (!keys.empty() && time <= keys.back().time)
        failJson(std::string(clock) + ": it is not after that before");
      keys.push_back({time, cameraIn(one)});
      if ((keys.back().camera.viewAngle == 0) != (keys.front().camera.viewAngle == 0))
        failJson("perspective and parallel projections cannot be mixed");
    } catch (const std::runtime_error& e) {
      failJson("camera " + std::to_string(keys.size() + 1) + ": " + e.what());
    }
  return keys;
}

CameraPath pathIn(const json& from) {
  if (!from.is_object()) failJson("use an object with \"cameras\"");
  refuseOthers(from, {"cameras", "between", "saved_camera"});
  CameraPath path;
  const char* clock = nullptr;
  path.keys = keysIn(from.value("cameras", json()), clock);
  path.begin = path.keys.front().time, path.end = path.keys.back().time;
  if (clock && clock == std::string("frame")) {
    if (path.end - path.begin >= kMostCameras) failJson("it has more than 100000 frames");
    path.pictures = static_cast<int>(path.end - path.begin) + 1;
  }
  const json between = from.value("between", json("spline"));
  if (between != "spline" && between != "linear") failJson("between: use spline or linear");
  if (between == "linear") path.between = CameraPath::Between::linear;
  if (from.contains("saved_camera")) try {
      path.saved.push_back(cameraIn(from["saved_camera"]));
    } catch (const std::runtime_error& e) { failJson(std::string("saved_camera: ") + e.what()); }
  return path;
}

json parsed(const std::string& text) {
  const json result = json::parse(text, nullptr, false);
  if (result.is_discarded()) failJson("it is no JSON");
  return result;
}

/// The result of `read` for the file's text. Errors name the file.
template <class Read>
auto readFile(const std::string& file, const Read& read) {
  const files::Content content = files::read(file, kMostBytes);
  if (!content.why.empty()) throw std::runtime_error(content.why);
  try {
    return read(content.text);
  } catch (const std::exception& e) { throw std::runtime_error(printable(file + ": " + e.what())); }
}

}  // namespace

CameraPath readCameraPath(const std::vector<std::string>& names) {
  const auto endsIn = [](const std::string& file, const char* ending) { return file.ends_with(ending); };
  if (names.size() == 1 && endsIn(names[0], ".json"))
    return readFile(names[0], [](const std::string& text) { return pathIn(parsed(text)); });
  if (names.size() == 1 && endsIn(names[0], ".pvsm")) return readFile(names[0], readPvsm);
  CameraPath path;
  for (const std::string& file : names) {
    if (!endsIn(file, ".pvcc"))
      throw std::runtime_error("--path " + printable(file) +
                               ": use one .json or .pvsm file, or .pvcc files, each with its own --path");
    path.keys.push_back({static_cast<double>(path.keys.size()), readFile(file, readPvcc)});
    if ((path.keys.back().camera.viewAngle == 0) != (path.keys.front().camera.viewAngle == 0))
      throw std::runtime_error(printable(file) + ": perspective and parallel projections cannot be mixed");
  }
  path.end = static_cast<double>(path.keys.size()) - 1;
  return path;
}

PathCamera readCamera(const std::string& file) {
  if (file.ends_with(".pvcc")) return readFile(file, readPvcc);
  if (!file.ends_with(".json"))
    throw std::runtime_error("--saved-camera " + printable(file) + ": use a .pvcc or .json file");
  return readFile(file, [](const std::string& text) { return cameraIn(parsed(text)); });
}

}  // namespace gluray::launcher
