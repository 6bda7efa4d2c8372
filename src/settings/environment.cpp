#include "settings/settings.h"

#include <cstdlib>
#include <string_view>
#include <utility>

namespace gluray {
namespace {

using Complain = void (*)(const std::string& line);

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

template <class T>
using Choice = std::pair<std::string_view, T>;

/// Sets `target` to the choice that the variable names; an empty or missing variable changes nothing.
template <class T, size_t N>
void choose(const char* name, const Choice<T> (&choices)[N], T& target, Complain complain) {
  const std::string_view value = environment(name);
  if (value.empty()) return;
  std::string words;
  for (size_t i = 0; i < N; ++i) {
    if (choices[i].first == value) {
      target = choices[i].second;
      return;
    }
    words += (i == 0 ? "" : i + 1 == N ? " or " : ", ") + std::string(choices[i].first);
  }
  complain(std::string(name) + "=" + std::string(value) + ": use " + words);
}

/// Sets `target` to the number that the variable holds, from 0 to `largest`; `meaning` of 0 is for the
/// complaint.
void readNumber(const char* name, long largest, const char* meaning, int& target, Complain complain) {
  const std::string value(environment(name));
  if (value.empty()) return;
  char* end = nullptr;
  const long number = std::strtol(value.c_str(), &end, 10);
  if (*end == '\0' && number >= 0 && number <= largest)
    target = static_cast<int>(number);
  else
    complain(std::string(name) + "=" + value + ": use a number from 0 (" + meaning + ") to " +
             std::to_string(largest));
}

void readQuirkSwitches(QuirkSet& quirks, Complain complain) {
  const std::string wrong = readQuirks(environment("GLURAY_QUIRKS"), quirks);
  if (!wrong.empty()) complain("GLURAY_QUIRKS: " + wrong);
}

}  // namespace

Session sessionFromEnvironment(Complain complain) {
  Session session;
  readNumber("GLURAY_THREADS", 1024, "all cores", session.settings.threads, complain);
  readNumber("GLURAY_EXPLAIN", 1000000000, "do not explain", session.explainFrames, complain);
  readQuirkSwitches(session.settings.quirks, complain);
  choose<BvhQuality>("GLURAY_BVH",
                     {{"auto", BvhQuality::automatic},
                      {"fast", BvhQuality::fast},
                      {"full", BvhQuality::full},
                      {"compact", BvhQuality::compact}},
                     session.settings.bvh, complain);
  choose<ShadingRate>("GLURAY_SHADING", {{"pixel", ShadingRate::pixel}, {"vertex", ShadingRate::vertex}},
                      session.settings.shading, complain);
  choose<Renderer>("GLURAY_RENDERER", {{"embree", Renderer::embree}, {"null", Renderer::null}},
                   session.settings.renderer, complain);
  choose<bool>("GLURAY_OFF", {{"0", false}, {"1", true}}, session.off, complain);
  choose<bool>("GLURAY_PICTURE", {{"0", false}, {"1", true}}, session.picture, complain);
  std::string_view level = session.logLevel;
  choose<std::string_view>("GLURAY_LOG_LEVEL",
                           {{"trace", "trace"},
                            {"debug", "debug"},
                            {"info", "info"},
                            {"warning", "warning"},
                            {"error", "error"},
                            {"off", "off"}},
                           level, complain);
  session.logLevel = level;
  session.reportFile = environment("GLURAY_REPORT");
  session.logFile = environment("GLURAY_LOG");
  return session;
}

}  // namespace gluray
