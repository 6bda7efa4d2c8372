#include "timeline/timeline_chart.h"

#include "text_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>

namespace gluray::launcher {
namespace {

constexpr double kLeft = 120, kChartWidth = 1060, kRow = 26, kLane = 9, kPanelGap = 46;  // pixels
constexpr int kLanes = 2;  // deeper spans share the last lane

/// Colour-blind safe colours (P. Tol's bright and muted schemes).
constexpr std::array<const char*, 12> kColors = {"#4477aa", "#ee6677", "#228833", "#ccbb44",
                                                 "#66ccee", "#aa3377", "#999933", "#882255",
                                                 "#44aa99", "#ddcc77", "#332288", "#bbbbbb"};

std::string escapedForSvg(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

/// Distance of ticks: a round number of milliseconds that gives about eight ticks.
double tickOf(double length) {
  const double raw = length / 8, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double step : {1.0, 2.0, 5.0})
    if (raw <= step * power) return step * power;
  return 10 * power;
}

class Panel {
 public:
  Panel(const Timeline& timeline, const Stretch& stretch, double top, std::ostream& out)
      : timeline_(timeline), stretch_(stretch), top_(top), out_(out) {}

  static double height(const Timeline& timeline) {
    return static_cast<double>(timeline.tracks.size()) * kRow + kPanelGap;
  }

  void draw(const std::string& title) {
    text(kLeft, top_ - 8, title + ": " + fixed(stretch_.from, 1) + " to " + fixed(stretch_.to, 1) + " ms",
         "start");
    for (size_t i = 0; i < timeline_.tracks.size(); ++i)
      text(kLeft - 8, rowOf(i) + 15, timeline_.tracks[i].name, "end");
    for (const double frame : timeline_.frames)
      if (frame >= stretch_.from && frame <= stretch_.to) line(xOf(frame), "#000000", "0.25");
    const double step = tickOf(stretch_.to - stretch_.from);
    for (double t = std::ceil(stretch_.from / step) * step; t <= stretch_.to; t += step) {
      line(xOf(t), "#888888", "0.2");
      text(xOf(t), rowOf(timeline_.tracks.size()) + 12, fixed(t, step < 1 ? 2 : 0), "middle");
    }
    drawSpans();
  }

 private:
  double xOf(double t) const {
    return kLeft + kChartWidth * (t - stretch_.from) / std::max(stretch_.to - stretch_.from, 1e-9);
  }
  double rowOf(size_t track) const { return top_ + static_cast<double>(track) * kRow; }

  /// Draws at most one of the spans narrower than a pixel in each pixel.
  void drawSpans() {
    std::map<std::pair<size_t, int>, double> drawnTo;
    for (const Timeline::Span& span : timeline_.spans) {
      if (span.end < stretch_.from || span.start > stretch_.to) continue;
      const int lane = std::min(span.depth, kLanes - 1);
      const double x0 = std::max(xOf(span.start), kLeft), x1 = std::min(xOf(span.end), kLeft + kChartWidth);
      double& last = drawnTo.try_emplace({span.track, lane}, -1).first->second;
      if (x1 - x0 < 1 && x1 < last + 0.5) continue;
      last = std::max(x1, x0 + 0.5);
      out_ << "<rect x=\"" << fixed(x0, 2) << "\" y=\""
           << fixed(rowOf(span.track) + 3 + lane * (kLane + 1), 1) << "\" width=\""
           << fixed(std::max(x1 - x0, 0.5), 2) << "\" height=\"" << kLane << "\" fill=\""
           << kColors[span.name % kColors.size()] << "\"><title>" << escapedForSvg(timeline_.names[span.name])
           << ": " << fixed(span.end - span.start, 3) << " ms"
           << (span.amount ? ", " + std::to_string(span.amount) : "") << "</title></rect>\n";
    }
  }
  void line(double x, const char* color, const char* opacity) {
    out_ << "<line x1=\"" << fixed(x, 1) << "\" x2=\"" << fixed(x, 1) << "\" y1=\"" << top_ << "\" y2=\""
         << rowOf(timeline_.tracks.size()) << "\" stroke=\"" << color << "\" opacity=\"" << opacity
         << "\"/>\n";
  }
  void text(double x, double y, const std::string& what, const char* anchor) {
    out_ << "<text x=\"" << fixed(x, 1) << "\" y=\"" << fixed(y, 1) << "\" text-anchor=\"" << anchor << "\">"
         << escapedForSvg(what) << "</text>\n";
  }

  const Timeline& timeline_;
  const Stretch& stretch_;
  double top_;
  std::ostream& out_;
};

}  // namespace

Stretch typicalFrames(const Timeline& timeline) {
  constexpr size_t kFrames = 5;
  const std::vector<double>& frames = timeline.frames;
  if (frames.size() > kFrames) {
    const size_t first = (frames.size() - kFrames) / 2;
    return {frames[first], frames[first + kFrames]};
  }
  // Programs that never show a window have no frames: takes a stretch of some batches from the middle.
  std::vector<double> batches;
  const auto batch =
      std::find(timeline.names.begin(), timeline.names.end(), "batch") - timeline.names.begin();
  for (const Timeline::Span& span : timeline.spans)
    if (span.name == static_cast<size_t>(batch)) batches.push_back(span.start);
  if (batches.size() > 2 * kFrames)
    return {batches[batches.size() / 2], batches[batches.size() / 2 + kFrames]};
  const double length = timeline.end - timeline.start;
  return {timeline.start + 0.45 * length, timeline.start + 0.55 * length};
}

void writeChart(const Timeline& timeline, const Stretch& near, std::ostream& out) {
  constexpr double kTop = 60;
  const double panel = Panel::height(timeline), height = kTop + 2 * panel;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kLeft + kChartWidth + 20 << "\" height=\""
      << height
      << "\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" "
         "fill=\"white\"/>\n";
  double x = kLeft;
  for (size_t i = 0; i < timeline.names.size(); ++i) {
    out << "<rect x=\"" << x << "\" y=\"10\" width=\"10\" height=\"10\" fill=\""
        << kColors[i % kColors.size()] << "\"/><text x=\"" << x + 14 << "\" y=\"19\">"
        << escapedForSvg(timeline.names[i]) << "</text>\n";
    x += 26 + 6.2 * static_cast<double>(timeline.names[i].size());
  }
  Panel(timeline, {timeline.start, timeline.end}, kTop, out).draw("whole run");
  Panel(timeline, near, kTop + panel, out).draw("close-up");
  out << "</svg>\n";
}

void printTimes(const Timeline& timeline, std::ostream& out) {
  struct Sum {
    double milliseconds = 0;
    size_t count = 0;
  };
  std::map<std::pair<size_t, size_t>, Sum> sums;
  for (const Timeline::Span& span : timeline.spans) {
    Sum& sum = sums[{span.track, span.name}];
    sum.milliseconds += span.end - span.start;
    ++sum.count;
  }
  TextTable table("llrrr");
  table.row({"thread", "does", "times", "ms", "ms each"});
  for (const auto& [key, sum] : sums)
    table.row({timeline.tracks[key.first].name, timeline.names[key.second], std::to_string(sum.count),
               fixed(sum.milliseconds, 1), fixed(sum.milliseconds / static_cast<double>(sum.count), 3)});
  out << fixed(timeline.end - timeline.start, 0) << " ms, " << timeline.frames.size() << " frames\n";
  out << table.text("  ");
}

}  // namespace gluray::launcher
