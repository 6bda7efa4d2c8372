#include "explain/explanation_text.h"

#include "base/printable.h"
#include "text_table.h"

#include <algorithm>
#include <vector>

namespace gluray::launcher {
namespace {

using nlohmann::json;

uint64_t number(const json& object, const char* name) { return object.at(name).get<uint64_t>(); }
std::string text(const json& object, const char* name) {
  return printable(object.at(name).get<std::string>());
}

std::string joined(const json& words) {
  std::string all;
  for (const json& word : words) all += (all.empty() ? "" : ", ") + printable(word.get<std::string>());
  return all;
}

/// Most triangles first, then most draws.
std::vector<json> sorted(const json& kinds) {
  std::vector<json> list(kinds.begin(), kinds.end());
  std::stable_sort(list.begin(), list.end(), [](const json& a, const json& b) {
    const uint64_t ta = number(a, "triangles"), tb = number(b, "triangles");
    return ta != tb ? ta > tb : number(a, "count") > number(b, "count");
  });
  return list;
}

/// How the real OpenGL drew a kind of draws that are not traced.
std::string rasterisedText(const json& kind) {
  const uint64_t culled = kind.value("culled", uint64_t{0});
  if (culled == 0) return "rasterised: " + text(kind, "reason");
  const double share = 100.0 * static_cast<double>(kind.value("leftOut", uint64_t{0})) /
                       std::max(1.0, static_cast<double>(number(kind, "triangles")));
  return grouped(culled) + " culled, " + fixed(share, 1) + " % left out: " + text(kind, "reason");
}

std::string drawTable(const json& kinds, double frames) {
  if (kinds.empty()) return "  none that GLuRay could see\n";
  TextTable table("llrrrll");
  table.row({"what", "how", "draws", "triangles", "ms/frame", "", "state"});
  for (const json& kind : sorted(kinds))
    table.row({text(kind, "primitive"), text(kind, "path"), grouped(number(kind, "count")),
               grouped(number(kind, "triangles")), fixed(kind.at("ms").get<double>() / frames, 3),
               kind.at("traced").get<bool>() ? "traced" : rasterisedText(kind), joined(kind.at("state"))});
  return table.text("  ");
}

/// Says that the program composes surfaces in the stencil buffer; empty where it does not.
std::string stencilLines(const json& kinds) {
  uint64_t draws = 0;
  for (const json& kind : kinds) {
    const json& state = kind.at("state");
    if (std::find(state.begin(), state.end(), "stencil") != state.end() &&
        text(kind, "reason") == "colour mask")
      draws += number(kind, "count");
  }
  if (draws == 0) return "";
  return wrapped(
      "The program composes surfaces with the stencil buffer, as OpenCSG does to show differences and "
      "intersections of solids: " +
          grouped(draws) +
          " draws count surfaces in the stencil buffer without drawing colours. These counts decide what "
          "later draws show. A ray finds the nearest surface and does not count, so the real OpenGL makes "
          "all of "
          "these draws.",
      100, "  ");
}

std::string tracingLine(const json& report) {
  const json& ms = report.at("ms");
  const auto part = [&](const char* name) { return fixed(ms.at(name).get<double>(), 3); };
  return "  tracing, ms/frame: capture " + part("capture") + ", build " + part("build") + ", trace " +
         part("trace") + ", write-back " + part("present") + "; " + grouped(number(report, "flushes")) +
         " batches, " + grouped(number(report, "repeated")) + " of them unchanged, " +
         grouped(number(report.at("bvh"), "builds")) + " acceleration structures built\n";
}

/// Numbers of draws by reason, after `what`; empty where there are none.
std::string reasonsLine(const std::string& what, const json& reasons) {
  std::string all;
  for (const auto& [reason, draws] : reasons.items())
    all += (all.empty() ? "" : ", ") + grouped(draws.get<uint64_t>()) + " (" + printable(reason) + ")";
  return all.empty() ? "" : wrapped(what + ": " + all, 100, "  ");
}

/// Draws of the real OpenGL with light from settings, and why others have none; empty: nothing asks for it.
std::string litLines(const json& report) {
  const json lit = report.value("lit", json::object());
  const uint64_t draws = lit.value("draws", uint64_t{0});
  return (draws ? "  light on " + grouped(draws) + " rasterised draws\n" : std::string()) +
         reasonsLine("rasterised draws without light", report.at("explain").value("notLit", json::object()));
}

/// The family of each shader program, its draws, and why a program has no family or its draws are not traced.
std::string programLines(const json& programs) {
  if (programs.empty()) return "";
  std::string all = "\nshader programs\n";
  for (const json& p : programs) {
    const uint64_t traced = number(p, "traced"), rasterised = number(p, "rasterised");
    all += "  program " + std::to_string(number(p, "name")) + ", " +
           (p.at("family").is_null() ? "no family fits" : text(p, "family")) + ": " + grouped(traced) +
           " draws traced, " + grouped(rasterised) + " rasterised, " + grouped(number(p, "triangles")) +
           " triangles\n";
    for (const char* key : {"why", "note"})
      if (!text(p, key).empty()) all += wrapped(text(p, key), 100, "    ");
  }
  return all;
}

std::string contextLines(const json& contexts) {
  std::string all;
  for (const json& c : contexts)
    all += "  " + text(c, "api") + ", " + text(c, "profile") + ", " +
           (c.at("doubleBuffered").get<bool>() ? "double-buffered" : "single-buffered") + ", " +
           text(c, "version") + ", " + text(c, "renderer") + ": " + grouped(number(c, "frames")) +
           " frames, " + grouped(number(c, "traced")) + " draws traced, " + grouped(number(c, "rasterised")) +
           " rasterised" +
           (text(c, "profile") != "ES" ? "" : "; the real OpenGL draws all of it, not counted") + "\n";
  return all;
}

std::string targetLines(const json& targets) {
  TextTable table("lrl");
  for (const json& t : targets) {
    const uint64_t samples = number(t, "samples");
    table.row(
        {number(t, "name") == 0 ? "the window" : "framebuffer object " + std::to_string(number(t, "name")),
         std::to_string(number(t, "width")) + " x " + std::to_string(number(t, "height")),
         (samples > 1 ? std::to_string(samples) + " samples, " : "") + grouped(number(t, "traced")) +
             " draws traced, " + grouped(number(t, "rasterised")) + " rasterised"});
  }
  return table.empty() ? "  nothing was drawn into any\n" : table.text("  ");
}

std::string quirkLines(const json& quirks) {
  TextTable table("lll");
  for (const json& q : quirks) {
    const uint64_t uses = number(q, "uses");
    table.row({text(q, "name"), q.at("on").get<bool>() ? "on" : "off",
               uses ? "made a difference " + grouped(uses) + " times" : "made no difference"});
  }
  return table.text("  ");
}

/// Whether a call is a query: the real OpenGL answers it and nothing changes, so the list omits it.
bool isQuery(const std::string& name) { return name.starts_with("glGet") || name.starts_with("glIs"); }

std::string unknownCallLines(const json& report) {
  TextTable table("lr");
  for (const auto& [name, count] : report.at("unknownCalls").items())
    if (!isQuery(name)) table.row({name, grouped(count.get<uint64_t>())});
  std::string all;
  if (!table.empty())
    all += "\ncalls that GLuRay does not model, left to the real OpenGL\n" + table.text("  ");
  const json& asked = report.at("explain").at("unknownFunctions");
  if (!asked.empty())
    all +=
        "\nfunctions that the program looked up and GLuRay does not know: it does not see calls to them\n" +
        wrapped(joined(asked), 100, "  ");
  return all;
}

std::string heading(const json& report) {
  const double percent = tracedPercent(report);
  const json& triangles = report.at("triangles");
  const uint64_t all = number(triangles, "traced") + number(triangles, "rasterised");
  return text(report, "program") + " (process " + std::to_string(number(report, "pid")) +
         "): " + grouped(number(report, "frames")) + " frames" +
         (percent < 0 ? "" : ", " + fixed(percent, 1) + " % of " + grouped(all) + " triangles traced") + "\n";
}

/// Says that calls may have bypassed GLuRay; empty where none could.
std::string walkedPastLines(const json& report) {
  const std::string driver = printable(report.value("walkedPast", std::string()));
  if (driver.empty()) return "";
  return "\ncalls that bypass GLuRay\n" +
         wrapped(
             "the dynamic linker finds the driver's gl functions first (" + driver +
                 "): libraries that are loaded later call the driver, GLuRay does not see these calls, and "
                 "the image may be wrong",
             100, "  ");
}

/// How many frames lagged, and why others did not; empty while lag is off.
std::string lagLine(const json& report) {
  const json lag = report.value("lag", json::object());
  if (!lag.value("on", false)) return "";
  std::string others;
  for (const auto& [why, frames] : lag.at("atOnce").items())
    others +=
        (others.empty() ? "; shown at once: " : ", ") + grouped(frames.get<uint64_t>()) + " (" + why + ")";
  return "\nframe lag: " + grouped(number(lag, "later")) + " frames were shown later" + others + "\n";
}

std::string noise(const json& object) {
  const double value = object.value("noise", 0.0);
  return value > 0 ? ", noise " + fixed(value, 4) : "";
}

/// How far images with light were refined; empty where none was.
std::string lightLine(const json& report) {
  const json light = report.value("light", json::object()), idle = light.value("idle", json::object());
  const auto passes = light.value("passes", uint64_t{0}), idlePasses = idle.value("passes", uint64_t{0});
  const auto refused = idle.value("refused", uint64_t{0});
  if (passes + idlePasses + refused == 0) return "";
  return "  light: " + grouped(passes) + " passes" + noise(light) + "; while the program was idle " +
         grouped(idlePasses) + " passes over " + grouped(idle.value("frames", uint64_t{0})) + " frames, " +
         grouped(idle.value("finished", uint64_t{0})) + " finished, " + grouped(refused) + " not refined" +
         noise(idle) + "\n";
}

std::string warningLines(const json& report) {
  const json warnings = report.value("warnings", json::array());
  std::string lines = warnings.empty() ? "" : "\nwarnings\n";
  for (const json& warning : warnings)
    if (warning.is_string()) lines += "  " + printable(warning.get<std::string>()) + "\n";
  return lines;
}

}  // namespace

double tracedPercent(const json& report) {
  const double traced = report.at("triangles").at("traced").get<double>(),
               all = traced + report.at("triangles").at("rasterised").get<double>();
  return all > 0 ? 100 * traced / all : -1;
}

std::string explanationText(const json& report) {
  const json& explain = report.at("explain");
  const double frames = std::max(1.0, report.at("frames").get<double>());
  return heading(report) + "\ndraws, of all frames\n" + drawTable(explain.at("kinds"), frames) +
         stencilLines(explain.at("kinds")) +
         reasonsLine("large draws that were not culled", explain.value("notCulled", json::object())) +
         litLines(report) + tracingLine(report) + lightLine(report) + lagLine(report) +
         programLines(explain.value("programs", json::array())) + "\ncontexts, through the door " +
         text(report, "door") + "\n" + contextLines(explain.at("contexts")) + walkedPastLines(report) +
         "\nframebuffers\n" + targetLines(explain.at("framebuffers")) + "\nquirks\n" +
         quirkLines(explain.at("quirks")) + unknownCallLines(report) + warningLines(report);
}

}  // namespace gluray::launcher
