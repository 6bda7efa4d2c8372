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

void readThreads(int& threads, Complain complain) {
  const std::string value(environment("GLURAY_THREADS"));
  if (value.empty()) return;
  char* end = nullptr;
  const long number = std::strtol(value.c_str(), &end, 10);
  if (*end == '\0' && number >= 0 && number <= 1024)
    threads = static_cast<int>(number);
  else
    complain("GLURAY_THREADS=" + value + ": use a number from 0 (all cores) to 1024");
}

}  // namespace

Session sessionFromEnvironment(Complain complain) {
  Session session;
  readThreads(session.settings.threads, complain);
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
