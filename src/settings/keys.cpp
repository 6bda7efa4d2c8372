#include "settings/keys.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace gluray {
namespace {

template <class T>
using Choice = std::pair<std::string_view, T>;

template <class T, size_t N>
std::string choose(std::string_view value, const Choice<T> (&choices)[N], T& target) {
  std::string words;
  for (size_t i = 0; i < N; ++i) {
    if (choices[i].first == value) return target = choices[i].second, "";
    words += (i == 0 ? "" : i + 1 == N ? " or " : ", ") + std::string(choices[i].first);
  }
  return "use " + words;
}

/// From `least`, which means `what`, to `largest`.
std::string setNumber(std::string_view value, int least, const char* what, int largest, int& target) {
  int number = -1;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size() || number < least || number > largest)
    return "use a number from " + std::to_string(least) + " (" + what + ") to " + std::to_string(largest);
  return target = number, "";
}

std::string setSwitch(std::string_view value, bool& target) {
  return choose<bool>(value, {{"0", false}, {"1", true}, {"false", false}, {"true", true}}, target);
}

std::string setLogLevel(std::string_view value, std::string& level) {
  std::string_view chosen;
  const std::string why = choose<std::string_view>(value,
                                                   {{"trace", "trace"},
                                                    {"debug", "debug"},
                                                    {"info", "info"},
                                                    {"warning", "warning"},
                                                    {"error", "error"},
                                                    {"off", "off"}},
                                                   chosen);
  if (why.empty()) level = chosen;
  return why;
}

struct Key {
  std::string_view name;
  std::string (*set)(Session&, std::string_view value);
  bool inFile = true;
};

const Key kKeys[] = {
    {"threads",
     [](Session& s, std::string_view v) { return setNumber(v, 0, "all cores", 1024, s.settings.threads); }},
    {"engine",
     [](Session& s, std::string_view v) {
       return choose<Engine>(
           v, {{"auto", Engine::automatic}, {"always", Engine::always}, {"never", Engine::never}},
           s.settings.engine);
     }},
    {"bvh",
     [](Session& s, std::string_view v) {
       return choose<BvhQuality>(v,
                                 {{"auto", BvhQuality::automatic},
                                  {"fast", BvhQuality::fast},
                                  {"full", BvhQuality::full},
                                  {"compact", BvhQuality::compact},
                                  {"least", BvhQuality::least}},
                                 s.settings.bvh);
     }},
    {"shading",
     [](Session& s, std::string_view v) {
       return choose<ShadingRate>(
           v,
           {{"pixel", ShadingRate::pixel}, {"vertex", ShadingRate::vertex}, {"sample", ShadingRate::sample}},
           s.settings.shading);
     }},
    {"renderer",
     [](Session& s, std::string_view v) {
       return choose<Renderer>(v, {{"embree", Renderer::embree}, {"null", Renderer::null}},
                               s.settings.renderer);
     }},
    {"spp",
     [](Session& s, std::string_view v) { return setNumber(v, 1, "the centre", kMostSpp, s.settings.spp); }},
    {"lag",
     [](Session& s, std::string_view v) {
       return choose<LagMode>(v, {{"off", LagMode::off}, {"on", LagMode::on}, {"auto", LagMode::automatic}},
                              s.lag);
     }},
    {"hud", [](Session& s, std::string_view v) { return setSwitch(v, s.hud); }},
    {"off", [](Session& s, std::string_view v) { return setSwitch(v, s.off); }},
    {"quirks", [](Session& s, std::string_view v) { return readQuirks(v, s.settings.quirks); }},
    {"program-families", [](Session& s, std::string_view v) { return s.programFamilies = v, std::string(); }},
    {"report", [](Session& s, std::string_view v) { return s.reportFile = v, std::string(); }},
    {"timeline", [](Session& s, std::string_view v) { return s.timelineFile = v, std::string(); }},
    {"log", [](Session& s, std::string_view v) { return s.logFile = v, std::string(); }},
    {"log-level", [](Session& s, std::string_view v) { return setLogLevel(v, s.logLevel); }},
    {"explain",
     [](Session& s, std::string_view v) {
       return setNumber(v, 0, "do not explain", 1000000000, s.explainFrames);
     },
     false},
    {"picture", [](Session& s, std::string_view v) { return setSwitch(v, s.picture); }, false},
};

}  // namespace

std::span<const std::string_view> settingKeys() {
  static const auto names = [] {
    std::array<std::string_view, std::size(kKeys)> all;
    std::transform(std::begin(kKeys), std::end(kKeys), all.begin(), [](const Key& key) { return key.name; });
    return all;
  }();
  return names;
}

bool isForFiles(std::string_view key) {
  return std::any_of(std::begin(kKeys), std::end(kKeys),
                     [&](const Key& k) { return k.name == key && k.inFile; });
}

std::string setSetting(Session& session, std::string_view key, std::string_view value) {
  const auto* found =
      std::find_if(std::begin(kKeys), std::end(kKeys), [&](const Key& k) { return k.name == key; });
  return found == std::end(kKeys) ? "no such setting" : found->set(session, value);
}

}  // namespace gluray
