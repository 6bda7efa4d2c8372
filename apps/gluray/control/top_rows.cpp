#include "control/top_rows.h"

#include "base/printable.h"
#include "text_table.h"

#include <cmath>
#include <initializer_list>

namespace gluray::launcher {
namespace {

using nlohmann::json;

/// The number below these names; negative if there is none.
double at(const json& object, std::initializer_list<const char*> names) {
  const json* one = &object;
  for (const char* const name : names) {
    if (!one->is_object()) return -1;
    const auto found = one->find(name);
    if (found == one->end()) return -1;
    one = &*found;
  }
  const double number = one->is_number() ? one->get<double>() : -1;
  return std::isfinite(number) && number >= 0 && number < 1e18 ? number : -1;
}

std::string textAt(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? printable(found->get<std::string>()) : "";
}

const json* rankIn(const json& state, double rank) {
  const auto ranks = state.find("ranks");
  if (ranks == state.end() || !ranks->is_array()) return nullptr;
  for (const json& one : *ranks)
    if (at(one, {"rank"}) == rank) return &one;
  return nullptr;
}

/// Of the images since the state before, or of all if there were none.
double perImage(const json& now, const json* before, std::initializer_list<const char*> names) {
  const double mean = at(now, names), images = at(now, {"images"});
  if (!before || mean < 0) return mean;
  const double earlierMean = at(*before, names), earlier = at(*before, {"images"});
  if (earlierMean < 0 || earlier < 0 || images <= earlier) return mean;
  return std::fmax(0, (mean * images - earlierMean * earlier) / (images - earlier));
}

/// A second; negative: not known.
double rate(const json& now, const json* before, double seconds, std::initializer_list<const char*> names) {
  const double last = at(now, names), first = before ? at(*before, names) : -1;
  return first < 0 || last < first || seconds <= 0 ? -1 : (last - first) / seconds;
}

TopRow rowOfRank(const json& now, const json* before, double seconds) {
  TopRow row;
  row.rank = static_cast<int64_t>(at(now, {"rank"}));
  row.host = textAt(now, "host"), row.state = textAt(now, "state");
  if (row.state == "connected") row.state.clear();
  row.memory = at(now, {"memory"});
  if (at(now, {"images"}) < 0) return row;
  row.fps = rate(now, before, seconds, {"images"});
  row.eye = perImage(now, before, {"ms", "eye"}), row.light = perImage(now, before, {"ms", "light"});
  row.waiting = 0;
  for (const char* const what : {"scenes", "depths", "answers"})
    row.waiting += std::fmax(0, perImage(now, before, {"ms", "waiting", what}));
  row.sent = rate(now, before, seconds, {"bytes", "sent"});
  row.received = rate(now, before, seconds, {"bytes", "received"});
  return row;
}

std::string cell(double number, int digits) { return number < 0 ? "-" : fixed(number, digits); }

json known(double number) { return number < 0 ? json() : json(number); }

}  // namespace

void TopProgram::take(const json& state, double now) {
  if (!state.is_object()) return;
  before_ = std::move(last_), beforeAt_ = lastAt_;
  last_ = state, lastAt_ = now;
  ++states_;
}

std::vector<TopRow> TopProgram::rows() const {
  std::vector<TopRow> rows;
  if (states_ == 0) return rows;
  if (const auto ranks = last_.find("ranks"); ranks != last_.end() && ranks->is_array())
    for (const json& one : *ranks)
      if (at(one, {"rank"}) >= 0)
        rows.push_back(
            rowOfRank(one, states_ > 1 ? rankIn(before_, at(one, {"rank"})) : nullptr, lastAt_ - beforeAt_));
  if (!rows.empty()) return rows;
  TopRow one;
  one.rank = program_.ranks > 1 ? 0 : -1;  // its state is that of rank 0
  one.host = printable(program_.host);
  one.fps = at(last_, {"fps"}), one.memory = at(last_, {"memory"});
  return {one};
}

std::string topTable(const std::vector<TopProgram>& programs) {
  TextTable table("lrlrrrrrrr");
  table.row({"program", "rank", "host", "fps", "eye ms", "light ms", "waiting ms", "sent MB/s",
             "received MB/s", "memory MB"});
  for (const TopProgram& program : programs)
    for (const TopRow& row : program.rows())
      table.row({labelOf(program.program()), row.rank < 0 ? "-" : std::to_string(row.rank), row.host,
                 row.state.empty() ? cell(row.fps, 1) : row.state, cell(row.eye, 1), cell(row.light, 1),
                 cell(row.waiting, 1), cell(row.sent / 1e6, 2), cell(row.received / 1e6, 2),
                 cell(row.memory / 1e6, 0)});
  return table.text("");
}

json topJson(const std::vector<TopProgram>& programs) {
  json list = json::array();
  for (const TopProgram& program : programs)
    for (const TopRow& row : program.rows())
      list.push_back({{"program", program.program().number},
                      {"name", program.program().name},
                      {"pid", program.program().pid},
                      {"rank", row.rank < 0 ? json() : json(row.rank)},
                      {"host", row.host},
                      {"state", row.state.empty() ? "runs" : row.state},
                      {"fps", known(row.fps)},
                      {"eyeMs", known(row.eye)},
                      {"lightMs", known(row.light)},
                      {"waitingMs", known(row.waiting)},
                      {"sentPerSecond", known(row.sent)},
                      {"receivedPerSecond", known(row.received)},
                      {"memory", known(row.memory)}});
  return list;
}

}  // namespace gluray::launcher
