#include "control/scene/light.h"

#include "control/program_lists.h"
#include "control/scene/point.h"
#include "control/values/change.h"
#include "control/values/short_names.h"
#include "say.h"

#include <iostream>

namespace gluray::launcher {
namespace {

using nlohmann::json;

// Of the rigs with a key light, this one keeps the image's brightness: it has a light at the viewer, too.
// By lights.attached = auto it is fixed to the scene, as what the program answers where there is no key
// light; three-point is fixed to the camera. The panel and Python take the same one.
constexpr const char* kRigForHighlight = "headlight+key";

/// Why it takes the place of what shines; empty: that has a key light.
std::string whyOtherRig(const json& rig) {
  if (rig == "program") return "The program's own lights have no key light";
  return rig == "sky" ? "lights = sky has no key light" : "";
}

std::vector<std::string> lightCells(const AnswerReader& light) {
  return {light.text("name"),
          light.text("from"),
          light.text("kind"),
          light.numberText("azimuth"),
          light.numberText("elevation"),
          light.numbersText("position", 3),
          light.text("color"),
          light.numberText("strength"),
          light.numberText("size")};
}

int listLights(const CommandLine& line) {
  return printLists(
      line, {"lights",
             "lllrrllrr",
             {"name", "from", "kind", "azimuth", "elevation", "position", "color", "strength", "size"},
             "no lights",
             [](HubSession& hub, const RunningProgram& program) {
               const json answer = callOf(hub, program, "lights", json::object());
               return AnswerReader(answer).list("lights");
             },
             lightCells});
}

/// The settings with which the highlight is there; null: nothing is there. `why`: why `lights` is one of
/// them. Throws.
json settingsForHighlight(HubSession& hub, const RunningProgram& program, const Point& point,
                          std::string& why) {
  const json found = callOf(hub, program, "highlight", argumentsOf(point));
  const AnswerReader reader(found);
  if (!reader.whole("object")) return {};
  const auto azimuth = reader.number("azimuth"), elevation = reader.number("elevation");
  if (!azimuth || !elevation) return {};
  json values = {{"lights.azimuth", *azimuth}, {"lights.elevation", *elevation}};
  why = whyOtherRig(valuesIn(hub, program, {"lights"})["lights"]);
  if (!why.empty()) values["lights"] = kRigForHighlight;
  return values;
}

int lightAt(const CommandLine& line, const Point& point) {
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  std::string why;
  const json values = labelled(program, [&] { return settingsForHighlight(hub, program, point, why); });
  if (values.is_null()) return say(labelOf(program) + ": nothing is there"), 1;
  const int code = sendChange(line, hub, {program}, {{"type", "set"}, {"values", values}});
  if (code == 0 && !why.empty() && !line.json)
    std::cout << why << ": lights = " << kRigForHighlight << " is set, too.\n";
  return code;
}

}  // namespace

int changeLights(const CommandLine& line) {
  const std::vector<std::string>& words = line.control.words;
  if (words.empty()) return listLights(line);
  if (words[0] == "at") {
    Point point;
    if (const std::string why = readPoint("light at", words, point); !why.empty())
      return say(why), kUsageError;
    return lightAt(line, point);
  }
  json values = json::object();
  if (const std::string why = readShortPairs({"lights", "rig"}, words, values); !why.empty())
    return say(why), kUsageError;
  return changeValues(line, values);
}

}  // namespace gluray::launcher
