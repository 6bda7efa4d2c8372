#include "intercept/reports/explanation.h"

#include "base/never_destroyed.h"
#include "frame/tracing/tracer_info.h"
#include "gl/programs/match.h"
#include "intercept/session/session.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>

namespace gluray::intercept {
namespace {

using nlohmann::json;

struct Notes {
  std::mutex mutex;
  std::set<std::string> unknownFunctions;
  std::optional<present::RecordedImage> image;  // not yet written to files
  json imageText;
};

Notes& notes() {
  static NeverDestroyed<Notes> notes;
  return *notes;
}

double milliseconds(double seconds) { return 1000.0 * seconds; }

json kindsOf(const gl::KindTable& table) {
  json list = json::array();
  for (const auto& [kind, cost] : table)
    list.push_back({{"primitive", gl::describe(kind.primitive)},
                    {"path", gl::describe(kind.path)},
                    {"state", gl::describeStates(kind.state)},
                    {"traced", kind.reason == gl::Reason::traced},
                    {"reason", gl::describe(kind.reason)},
                    {"count", cost.count},
                    {"triangles", cost.triangles},
                    {"culled", cost.culled},
                    {"leftOut", cost.leftOut},
                    {"ms", milliseconds(cost.seconds)}});
  return list;
}

/// Numbers of draws, by reason.
template <class Why>
json byReason(const std::map<Why, uint64_t>& counts) {
  json all = json::object();
  for (const auto& [reason, count] : counts) all[std::string(gl::describe(reason))] = count;
  return all;
}

/// The shader programs, sorted by decreasing number of triangles.
json programsOf(const gl::ProgramTable& table) {
  std::vector<gl::ProgramUse> uses;
  for (const auto& [known, use] : table) uses.push_back(use);
  std::sort(uses.begin(), uses.end(), [](const gl::ProgramUse& a, const gl::ProgramUse& b) {
    return a.triangles != b.triangles ? a.triangles > b.triangles
                                      : a.program->program.name < b.program->program.name;
  });
  json list = json::array();
  for (const gl::ProgramUse& use : uses) {
    const gl::KnownProgram& known = *use.program;
    json uniforms = json::array(), attributes = json::array();
    for (const auto& [name, place] : known.program.uniforms) uniforms.push_back(name);
    for (const auto& [name, place] : known.program.attributes) attributes.push_back(name);
    list.push_back({{"name", known.program.name},
                    {"family", known.family ? json(known.family->name) : json(nullptr)},
                    {"why", known.why.empty() ? use.why : known.why},
                    {"note", known.note},
                    {"traced", use.traced},
                    {"rasterised", use.rasterised},
                    {"triangles", use.triangles},
                    {"uniforms", std::move(uniforms)},
                    {"attributes", std::move(attributes)}});
  }
  return list;
}

json targetsOf(const gl::TargetTable& table) {
  json list = json::array();
  for (const auto& [name, use] : table)
    list.push_back({{"name", name},
                    {"width", use.width},
                    {"height", use.height},
                    {"samples", use.samples},
                    {"traced", use.traced},
                    {"rasterised", use.rasterised}});
  return list;
}

json contextsOf(const std::vector<ContextSummary>& contexts) {
  json list = json::array();
  for (const ContextSummary& c : contexts)
    list.push_back({{"api", c.api},
                    {"profile", c.profile},
                    {"version", c.version},
                    {"renderer", c.renderer},
                    {"doubleBuffered", c.doubleBuffered},
                    {"frames", c.frames},
                    {"swaps", c.swaps},
                    {"traced", c.drawsTraced},
                    {"rasterised", c.drawsRasterised}});
  return list;
}

json quirksNow() {
  json list = json::array();
  for (int i = 0; i < kQuirkCount; ++i) {
    const auto quirk = static_cast<Quirk>(i);
    list.push_back({{"name", describe(quirk).name},
                    {"on", settingsOfNow().current()->quirks.has(quirk)},
                    {"uses", useCount(quirk)},
                    {"reason", describe(quirk).reason}});
  }
  return list;
}

/// Files mapped by this process whose names begin with one of `starts`.
std::set<std::string> mappedFiles(std::initializer_list<std::string_view> starts) {
  std::set<std::string> files;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const size_t path = line.find('/');
    if (path == line.npos) continue;
    const std::string name = line.substr(line.rfind('/') + 1);
    if (std::any_of(starts.begin(), starts.end(),
                    [&](std::string_view start) { return name.starts_with(start); }))
      files.insert(line.substr(path));
  }
  return files;
}

/// Function names in the file of libglvnd's dispatch library.
std::set<std::string> dispatchNames() {
  std::set<std::string> names;
  for (const std::string& file : mappedFiles({"libGLdispatch.so"})) {
    std::ifstream stream(file, std::ios::binary);
    for (std::string name; std::getline(stream, name, '\0');)
      if (name.starts_with("gl")) names.insert(name);
  }
  return names;
}

/// libglvnd looks up every function that it knows. The program looked up the remaining names.
json askedByProgram(const std::set<std::string>& names) {
  static const std::set<std::string>& known = *new std::set<std::string>(dispatchNames());
  json asked = json::array();
  for (const std::string& name : names)
    if (!known.count(name)) asked.push_back(name);
  return asked;
}

json machine() {
  const frame::TracerInfo info = frame::tracerInfo(settingsOfNow().current()->threads);
  return {{"embree", info.embree},   {"tbb", info.tbb},
          {"kernels", info.kernels}, {"rayPacket", info.rayPacket},
          {"threads", info.threads}, {"libraries", mappedFiles({"libembree", "libtbb"})},
          {"problem", info.problem}};
}

uint64_t countOf(const present::RecordedImage& image, present::PixelOrigin origin) {
  return static_cast<uint64_t>(std::count(image.origin.begin(), image.origin.end(), origin));
}

json imageText(const present::RecordedImage& image, const std::string& base) {
  return {{"frame", image.frame},
          {"width", image.width},
          {"height", image.height},
          {"traced", countOf(image, present::PixelOrigin::traced)},
          {"drawnOver", countOf(image, present::PixelOrigin::drawnOver)},
          {"elsewhere", image.elsewhere},
          {"file", base}};
}

json newestImage(const std::string& base) {
  Notes& n = notes();
  const std::lock_guard lock(n.mutex);
  if (n.image && present::writeImage(*n.image, base)) n.imageText = imageText(*n.image, base);
  n.image.reset();
  return n.imageText;
}

}  // namespace

void noteUnknownFunction(const char* name) noexcept {
  constexpr size_t kMax = 1000;
  try {
    Notes& n = notes();
    const std::lock_guard lock(n.mutex);
    if (n.unknownFunctions.size() < kMax) n.unknownFunctions.insert(name);
  } catch (...) {  // out of memory: the name is missing from the report
  }
}

void keepImage(present::RecordedImage image) {
  Notes& n = notes();
  const std::lock_guard lock(n.mutex);
  n.image = std::move(image);
}

json explanation(const Totals& totals, bool complete, const std::string& base) {
  static const json& onceMachine = *new json(machine());
  std::set<std::string> unknown;
  {
    const std::lock_guard lock(notes().mutex);
    unknown = notes().unknownFunctions;
  }
  return {{"complete", complete},
          {"wantedFrames", session().explainFrames},
          {"kinds", kindsOf(totals.kinds)},
          {"notCulled", byReason(totals.notCulled)},
          {"notLit", byReason(totals.notLit)},
          {"programs", programsOf(totals.programs)},
          {"framebuffers", targetsOf(totals.targets)},
          {"contexts", contextsOf(totals.list)},
          {"quirks", quirksNow()},
          {"unknownFunctions", askedByProgram(unknown)},
          {"machine", onceMachine},
          {"picture", newestImage(base)}};
}

}  // namespace gluray::intercept
