#include "intercept/control/scene_calls.h"

#include "control/messages/members.h"
#include "frame/questions/listed_lights.h"
#include "intercept/contexts/contexts.h"
#include "intercept/control/described_objects.h"
#include "intercept/control/shown_as_saved.h"
#include "settings/live/settings_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace gluray::intercept {
namespace {

using control::Called;
using nlohmann::json;

constexpr std::array<std::string_view, 7> kCalls = {"objects", "pick", "highlight", "lights",
                                                    "cameras", "save", "saved"};
constexpr int64_t kMaxObjects = 1000;  // in one answer

/// An integer member of the arguments; `otherwise` if it is missing. Throws if it is not an integer in its
/// range.
int64_t wholeIn(const json& arguments, const char* name, int64_t least, int64_t most, int64_t otherwise) {
  const json* const value = control::member(arguments, name);
  if (!value) return otherwise;
  if (const auto found = control::wholeNumber(value, least, most)) return *found;
  throw std::runtime_error(std::string(name) + ": use a number from " + std::to_string(least) + " to " +
                           std::to_string(most));
}

double numberOf(const json& arguments, const char* name, double least, double most, double otherwise) {
  const json* const value = control::member(arguments, name);
  if (!value && std::isfinite(otherwise)) return otherwise;
  const double found = value && value->is_number() ? value->get<double>() : NAN;
  if (found >= least && found <= most) return found;
  throw std::runtime_error(std::string(name) + ": use a number from " +
                           std::to_string(static_cast<int64_t>(least)) + " to " +
                           std::to_string(static_cast<int64_t>(most)));
}

/// The frames of all contexts that trace, or the last frame if there are none.
std::vector<gl::ShownFramePtr> allFrames(const gl::ShownFramePtr& last) {
  std::vector<gl::ShownFramePtr> frames = gl::shownFrames().all();
  if (frames.empty()) frames.push_back(last);
  return frames;
}

std::vector<ShownView> viewsOf(const std::vector<gl::ShownFramePtr>& frames) {
  std::vector<ShownView> views;
  for (const gl::ShownFramePtr& frame : frames)
    for (ShownView& view : intercept::viewsOf(*frame)) views.push_back(std::move(view));
  return views;
}

json frameOf(const gl::ShownFrame& frame) { return frame.frame != 0 ? json(frame.frame) : json(); }

}  // namespace

bool SceneCalls::knows(const std::string& name) {
  return std::find(kCalls.begin(), kCalls.end(), name) != kCalls.end();
}

Called SceneCalls::call(const std::string& name, const json& arguments, json& value, std::string& why) {
  const gl::ShownFramePtr frame = shownFrame();
  if (!frame && settingsSource().current()->engine == Engine::never) {
    why = "engine = never: the real OpenGL draws everything";
    return Called::done;
  }
  if (!frame) return Called::later;
  // Small scenes are traced only since somebody asks for them: the window still shows another frame.
  if (name == "save" && frame->batches.empty() && nowSeconds() - began_ < kFirstTraced) return Called::later;
  try {
    const Frames frames = allFrames(frame);
    if (name == "objects") value = objects(arguments, frames);
    if (name == "pick") value = pick(arguments, *frame, viewsOf(frames).size());
    if (name == "highlight") value = highlight(arguments, *frame);
    if (name == "lights") value = {{"lights", describeLights(viewsOf(frames))}};
    if (name == "save") value = save(arguments, *frame);
    if (name == "saved") value = {{"saved", saver_.isSaved(control::textIn(arguments, "file"))}};
    if (name == "cameras") value = {{"cameras", describeCameras(viewsOf(frames))}};
  } catch (const std::runtime_error& error) { why = error.what(); }
  return Called::done;
}

/// The last valid frame; null if none has been shown yet.
gl::ShownFramePtr SceneCalls::shownFrame() {
  gl::ShownFrames& frames = gl::shownFrames();
  const double now = nowSeconds();
  if (!frames.wanted()) began_ = now;
  frames.wantUntil(now + kRemembered);
  gl::ShownFramePtr frame = frames.last();
  if (!frame || now - began_ >= kDoubt) return frame;
  const bool mayFill = frame->batches.empty() ? totals().statistics.drawsTraced > 0
                                              : frame->frame == 0 && now - frame->when < kWhole;
  return mayFill ? nullptr : frame;
}

/// Lists the objects of these frames, unless the list is up to date.
void SceneCalls::list(const Frames& frames) {
  const bool same = std::equal(frames.begin(), frames.end(), listed_.begin(), listed_.end(),
                               [](const auto& frame, const auto& listed) { return listed.lock() == frame; });
  if (same) return;
  list_ = describeObjects(viewsOf(frames));
  listed_.assign(frames.begin(), frames.end());
  size_t hash = list_.size();
  for (json object : list_) {
    object.erase("lower"), object.erase("upper");
    hash = hash * 1000003 ^ std::hash<json>()(object);
  }
  if (version_ == 0 || hash != hash_) ++version_;
  hash_ = hash;
}

json SceneCalls::objects(const json& arguments, const Frames& frames) {
  constexpr int64_t kAny = control::kMaxFrame;
  const int64_t after = wholeIn(arguments, "after", 0, kAny, 0),
                count = wholeIn(arguments, "count", 1, kMaxObjects, kMaxObjects),
                known = wholeIn(arguments, "known", 0, kAny, -1);
  list(frames);
  json value{{"frame", frameOf(*frames.back())}, {"version", version_}, {"total", list_.size()}};
  if (known == static_cast<int64_t>(version_)) {
    value["same"] = true;
    return value;
  }
  json& objects = value["objects"] = json::array();
  for (const json& object : list_)
    if (object["object"].get<int64_t>() > after && static_cast<int64_t>(objects.size()) < count)
      objects.push_back(object);
  return value;
}

std::optional<ShownPoint> SceneCalls::pointAt(const json& arguments, const std::vector<ShownView>& views) {
  constexpr double kLargest = 1 << 15;  // pixels
  const glm::ivec2 known = windowSize_(), size = known == glm::ivec2(0) ? extentOf(views) : known;
  if (size.x <= 0 || size.y <= 0) return std::nullopt;  // nothing is drawn
  const double width = numberOf(arguments, "width", 1, kLargest, size.x),
               height = numberOf(arguments, "height", 1, kLargest, size.y);
  const double x = numberOf(arguments, "x", 0, width, NAN), y = numberOf(arguments, "y", 0, height, NAN);
  const glm::ivec2 pixel(static_cast<int>(x * size.x / width), static_cast<int>(y * size.y / height));
  const glm::ivec2 inside = glm::min(pixel, size - 1);
  const glm::dvec2 at(inside.x + 0.5, size.y - inside.y - 0.5);
  return intercept::pointAt(views, at, {known, gl::shownFrames().places()});
}

/// `allViews`: number of views in all frames, of which those of `frame` are the last.
json SceneCalls::pick(const json& arguments, const gl::ShownFrame& frame, size_t allViews) {
  const std::vector<ShownView> views = intercept::viewsOf(frame);
  const auto found = pointAt(arguments, views);
  json value{{"frame", frameOf(frame)}, {"object", nullptr},   {"view", nullptr}, {"position", nullptr},
             {"normal", nullptr},       {"distance", nullptr}, {"share", nullptr}};
  if (!found) return value;
  const ShownView& view = views[found->view];
  const scene::Snapshot& s = *found->snapshot;
  const glm::dmat4 world = view.viewFromWorld(s);
  const double scale =
      std::cbrt(std::abs(glm::determinant(glm::dmat3(world * glm::inverse(s.eyeFromWorld)))));
  if (found->instance->object.value != 0) value["object"] = found->instance->object.value;
  value["view"] = allViews - views.size() + found->view + 1;
  value["share"] = {found->share.x, found->share.y};
  value["position"] = arrayOf(glm::dvec3(world * glm::dvec4(frame::worldPoint(s, found->point), 1)));
  value["normal"] =
      arrayOf(glm::normalize(glm::dvec3(world * glm::dvec4(frame::worldDirection(s, found->normal), 0))));
  value["distance"] = frame::Viewer(s).distanceOf(found->point) * scale;
  return value;
}

json SceneCalls::save(const json& arguments, const gl::ShownFrame& frame) {
  const std::string file = control::textIn(arguments, "file");
  if (file.empty() || file.front() != '/') throw std::runtime_error("file: use a name with its whole path");
  ShownAsSaved shown = shownAsSaved(frame, {windowSize_(), gl::shownFrames().places()});
  if (shown.scene.batches.empty())
    throw std::runtime_error(
        "it has drawn no surface that is traced since it was asked: turn its view, and try again");
  json value{{"frame", frameOf(frame)}, {"box", nullptr}};
  if (const auto& box = shown.box) value["box"] = {box->x, box->y, box->z, box->w};
  saver_.start(std::move(shown.scene), file);
  return value;
}

json SceneCalls::highlight(const json& arguments, const gl::ShownFrame& frame) {
  const std::vector<ShownView> views = intercept::viewsOf(frame);
  const auto found = pointAt(arguments, views);
  json value{{"object", nullptr}, {"azimuth", nullptr}, {"elevation", nullptr}};
  if (!found) return value;
  const glm::dvec2 angles = frame::anglesOfHighlight(*found->snapshot, found->point, found->normal);
  if (found->instance->object.value != 0) value["object"] = found->instance->object.value;
  value["azimuth"] = angles.x, value["elevation"] = angles.y;
  return value;
}

}  // namespace gluray::intercept
