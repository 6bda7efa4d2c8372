#include "control/scene/camera.h"

#include "control/program_lists.h"
#include "control/scene/objects.h"
#include "control/scene/point.h"
#include "control/values/change.h"
#include "control/values/short_names.h"
#include "say.h"
#include "text_table.h"

namespace gluray::launcher {
namespace {

using nlohmann::json;

json camerasOf(HubSession& hub, const RunningProgram& program) {
  const json answer = callOf(hub, program, "cameras", json::object());
  return AnswerReader(answer).list("cameras");
}

/// "30°" of a perspective, "2.5 high" of a parallel projection.
std::string openingText(const AnswerReader& camera) {
  if (const auto angle = camera.number("angle")) return shortNumber(*angle) + " degrees";
  const auto height = camera.number("height");
  return height ? shortNumber(*height) + " high" : "-";
}

std::vector<std::string> cameraCells(const AnswerReader& camera) {
  const auto triangles = camera.whole("triangles");
  return {camera.wholeText("view"),
          camera.text("projection"),
          openingText(camera),
          camera.numbersText("position", 3),
          camera.numbersText("direction", 3),
          camera.numberText("near"),
          camera.numberText("far"),
          camera.numbersText("viewport", 4),
          triangles ? grouped(static_cast<unsigned long long>(*triangles)) : "-"};
}

int listCameras(const CommandLine& line) {
  return printLists(line, {"cameras",
                           "lllllrrlr",
                           {"view", "projection", "opening", "position", "direction", "near", "far",
                            "viewport", "triangles"},
                           "no cameras: nothing that it draws is traced",
                           camerasOf,
                           cameraCells});
}

/// The settings that put the surface at the point into focus; null: nothing is there. Throws.
json settingsForFocus(HubSession& hub, const RunningProgram& program, const Point& point) {
  const std::vector<double> share = shareIn(callOf(hub, program, "pick", argumentsOf(point)));
  if (share.empty()) return {};
  return {{"camera.focus", 0}, {"camera.focus-x", share[0]}, {"camera.focus-y", share[1]}};
}

/// Whether everything is sharp wherever the focus is.
bool lensIsClosed(HubSession& hub, const RunningProgram& program) {
  const json values = valuesIn(hub, program, {"camera.aperture", "camera.f-number"});
  return values["camera.aperture"] == 0 && values["camera.f-number"] == 0;
}

int focusAt(const CommandLine& line, const Point& point) {
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  const json values = labelled(program, [&] { return settingsForFocus(hub, program, point); });
  if (values.is_null()) return say(labelOf(program) + ": nothing is there"), 1;
  const int code = sendChange(line, hub, {program}, {{"type", "set"}, {"values", values}});
  if (code == 0 && !line.json && labelled(program, [&] { return lensIsClosed(hub, program); }))
    say("the lens is closed, and all is sharp: open it with gluray camera aperture=A or f-number=N");
  return code;
}

}  // namespace

int changeCamera(const CommandLine& line) {
  const std::vector<std::string>& words = line.control.words;
  if (words.empty()) return listCameras(line);
  if (words[0] == "focus") {
    Point point;
    if (const std::string why = readPoint("camera focus", words, point); !why.empty())
      return say(why), kUsageError;
    return focusAt(line, point);
  }
  json values = json::object();
  if (const std::string why = readShortPairs({"camera", ""}, words, values); !why.empty())
    return say(why), kUsageError;
  return changeValues(line, values);
}

}  // namespace gluray::launcher
