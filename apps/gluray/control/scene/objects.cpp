#include "control/scene/objects.h"

#include "control/program_lists.h"
#include "control/scene/point.h"
#include "say.h"
#include "text_table.h"

#include <algorithm>
#include <iostream>
#include <limits>

namespace gluray::launcher {
namespace {

using nlohmann::json;

constexpr int kMaxObjectsOfAnswer = 1000;  // objects

std::vector<std::string> objectCells(const AnswerReader& object) {
  const auto triangles = object.whole("triangles");
  const bool vertices = object.flag("vertexColors");
  const std::string color = object.text("color");
  return {object.wholeText("object"),
          object.wholeText("view"),
          object.text("shape"),
          triangles ? grouped(static_cast<unsigned long long>(*triangles)) : "-",
          color != "-" ? color
          : vertices   ? "vertices"
                       : "texture",
          object.text("material"),
          object.texts("hidden", '+')};
}

/// "object 3 in view 1 at 0 0 1, normal 0 0 1, distance 5"
std::string pickText(const AnswerReader& found) {
  if (!found.whole("object")) return "nothing is there";
  return "object " + found.wholeText("object") + " in view " + found.wholeText("view") + " at " +
         found.numbersText("position", 3) + ", normal " + found.numbersText("normal", 3) + ", distance " +
         found.numberText("distance");
}

}  // namespace

std::vector<double> shareIn(const json& found) {
  const AnswerReader reader(found);
  if (!reader.whole("object")) return {};
  std::vector<double> share = reader.numbers("share", 2);
  if (share.empty()) throw std::runtime_error("its answer cannot be read: 'share' is no list of 2 numbers");
  for (double& part : share) part = std::clamp(part, 0.0, 1.0);
  return share;
}

int64_t objectNumber(const json& object) {
  const auto number = AnswerReader(object).whole("object");
  if (!number || *number < 1 || *number > std::numeric_limits<uint32_t>::max())
    throw std::runtime_error("its answer cannot be read: 'object' is no number of an object");
  return *number;
}

json objectsOf(HubSession& hub, const RunningProgram& program) {
  json all = json::array();
  int64_t last = 0;
  while (true) {
    const json answer = callOf(hub, program, "objects", {{"after", last}, {"count", kMaxObjectsOfAnswer}});
    const AnswerReader reader(answer);
    const auto total = reader.whole("total");
    const json& some = reader.list("objects");
    for (const json& object : some) {
      const int64_t number = objectNumber(object);
      if (number <= last) throw std::runtime_error("its answer cannot be read: objects are not in order");
      last = number;
      all.push_back(object);
    }
    if (some.empty() || !total || all.size() >= static_cast<size_t>(*total)) return all;
  }
}

int listObjects(const CommandLine& line) {
  return printLists(line, {"objects",
                           "rrlrlll",
                           {"number", "view", "shape", "triangles", "color", "material", "hidden from"},
                           "no objects: nothing that it draws is traced",
                           objectsOf,
                           objectCells});
}

int pickObject(const CommandLine& line) {
  Point point;
  if (const std::string why = readPoint("pick", line.control.words, point); !why.empty())
    return say(why), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  labelled(program, [&] {
    const json found = callOf(hub, program, "pick", argumentsOf(point));
    const std::string text = pickText(AnswerReader(found));
    shareIn(found);
    json all = found;
    all.update(named(program));
    if (line.json)
      std::cout << jsonText(all) << "\n";
    else
      std::cout << labelOf(program) << ": " << text << "\n";
  });
  return 0;
}

}  // namespace gluray::launcher
