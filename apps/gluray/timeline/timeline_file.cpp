#include "timeline/timeline_file.h"

#include "base/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

/// The array of events. The file may be truncated: after a comma, before the bracket, within an event.
json readEvents(const std::string& file) {
  constexpr size_t kMax = size_t{4} << 30;
  const files::Content content = files::read(file, kMax);
  if (!content.why.empty()) throw std::runtime_error("cannot read " + file + ": " + content.why);
  const std::string& all = content.text;
  json events = json::parse(all, nullptr, false);
  if (events.is_array()) return events;
  const size_t last = all.rfind("},\n");
  if (all.rfind('[', 0) == 0 && last != std::string::npos)
    events = json::parse(all.substr(0, last + 1) + "]", nullptr, false);
  if (!events.is_array()) throw std::runtime_error(file + " was not written by gluray --timeline");
  return events;
}

class Reader {
 public:
  Timeline read(const json& events) {
    for (const json& event : events) {
      const std::string kind = event.value("ph", "");
      if (kind == "M" && event.value("name", "") == "thread_name")
        names_[event.value("tid", int64_t{0})] = event["args"].value("name", "");
      else if (kind == "X")
        addSpan(event);
      else if (kind == "i" && event.value("name", "") == "frame")
        timeline_.frames.push_back(event.value("ts", 0.0) / 1000);
    }
    finish();
    return std::move(timeline_);
  }

 private:
  template <class Key, class Make>
  static size_t indexOf(std::map<Key, size_t>& known, const Key& key, Make&& make) {
    const auto [it, fresh] = known.try_emplace(key, known.size());
    if (fresh) make();
    return it->second;
  }
  void addSpan(const json& event) {
    Timeline::Span span;
    const auto thread = event.value("tid", int64_t{0});
    const auto name = event.value("name", std::string());
    span.track = indexOf(tracks_, thread, [&] { timeline_.tracks.push_back({thread, ""}); });
    span.name = indexOf(spanNames_, name, [&] { timeline_.names.push_back(name); });
    span.start = event.value("ts", 0.0) / 1000;
    span.end = span.start + event.value("dur", 0.0) / 1000;
    if (event.contains("args")) span.amount = event["args"].value("n", uint64_t{0});
    timeline_.spans.push_back(span);
  }
  /// Sorts tracks and spans, and computes each span's depth.
  void finish() {
    for (Timeline::Track& track : timeline_.tracks)
      track.name =
          names_.contains(track.thread) ? names_[track.thread] : "thread " + std::to_string(track.thread);
    orderTracks();
    std::vector<Timeline::Span>& spans = timeline_.spans;
    std::sort(spans.begin(), spans.end(), [](const auto& a, const auto& b) {
      return a.start != b.start ? a.start < b.start : a.end > b.end;
    });
    std::vector<std::vector<double>> open(timeline_.tracks.size());
    for (Timeline::Span& span : spans) {
      std::vector<double>& ends = open[span.track];
      while (!ends.empty() && ends.back() <= span.start) ends.pop_back();
      span.depth = static_cast<int>(ends.size());
      ends.push_back(span.end);
      timeline_.end = std::max(timeline_.end, span.end);
    }
    timeline_.start = spans.empty() ? 0 : spans.front().start;
  }
  void orderTracks() {
    std::vector<size_t> order(timeline_.tracks.size()), place(order.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto rank = [&](size_t i) {
      const std::string& name = timeline_.tracks[i].name;
      return name == "program" ? 0 : name == "tracing" ? 1 : 2;
    };
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
      return rank(a) != rank(b) ? rank(a) < rank(b) : timeline_.tracks[a].name < timeline_.tracks[b].name;
    });
    // Background jobs of one name run one after the other, each in a thread of its own: they share a row.
    std::vector<Timeline::Track> sorted;
    for (const size_t i : order) {
      const Timeline::Track& track = timeline_.tracks[i];
      const bool joins = rank(i) == 2 && !sorted.empty() && sorted.back().name == track.name;
      if (!joins) sorted.push_back(track);
      place[i] = sorted.size() - 1;
    }
    timeline_.tracks = std::move(sorted);
    for (Timeline::Span& span : timeline_.spans) span.track = place[span.track];
  }

  Timeline timeline_;
  std::map<int64_t, std::string> names_;
  std::map<int64_t, size_t> tracks_;
  std::map<std::string, size_t> spanNames_;
};

}  // namespace

Timeline readTimeline(const std::string& file) {
  try {
    return Reader().read(readEvents(file));
  } catch (const json::exception&) {
    throw std::runtime_error(file + " was not written by gluray --timeline");
  }
}

}  // namespace gluray::launcher
