#include "model/controls.h"

#include "control/messages/base64.h"
#include "control/messages/members.h"
#include "control/messages/value.h"
#include "settings/values.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gluray::panel {
namespace {

using control::numberIn, control::textIn;
using nlohmann::json;

}  // namespace

QString Program::title() const {
  QString text = QString::fromStdString(name) + " (" + QString::number(pid) + ")";
  return ranks > 1 ? text + QString(", %1 ranks").arg(ranks) : text;
}

Program* Controls::findMutable(int number) {
  const auto found =
      std::find_if(programs_.begin(), programs_.end(), [&](const Program& p) { return p.number == number; });
  return found == programs_.end() ? nullptr : &*found;
}

const Program* Controls::find(int number) const { return const_cast<Controls*>(this)->findMutable(number); }

const Program* Controls::shown() const {
  if (chosen_) return find(*chosen_);
  return !all_ || programs_.empty() ? nullptr : &programs_.front();
}

std::vector<const Program*> Controls::targets() const {
  std::vector<const Program*> result;
  for (const Program& program : programs_)
    if (all_ || chosen_ == program.number) result.push_back(&program);
  return result;
}

int Controls::undoSteps() const {
  int most = 0;
  for (const Program* program : targets()) most = std::max(most, program->undo);
  return most;
}

int Controls::redoSteps() const {
  int most = 0;
  for (const Program* program : targets()) most = std::max(most, program->redo);
  return most;
}

bool Controls::isLive(const std::string& name) const {
  const std::vector<const Program*> all = targets();
  return std::any_of(all.begin(), all.end(), [&](const Program* program) {
    const auto known = program->values.find(name);
    return known != program->values.end() && known->second.layer == "live";
  });
}

Value Controls::value(const std::string& name) const {
  if (const Program* program = shown())
    if (const auto known = program->values.find(name); known != program->values.end()) return known->second;
  const Row* row = findSetting(name);
  return {row ? control::valueOf(*row, printValue(*row, Session{})) : json(), "built-in", ""};
}

bool Controls::differs(const std::string& name) const {
  if (!all_) return false;
  const json first = value(name).value;
  return std::any_of(programs_.begin(), programs_.end(), [&](const Program& program) {
    const auto known = program.values.find(name);
    const Row* row = findSetting(name);
    return row &&
           (known != program.values.end() ? known->second.value
                                          : control::valueOf(*row, printValue(*row, Session{}))) != first;
  });
}

void Controls::choose(int number) {
  const Program* program = find(number);
  if (!program || chosen_ == number) return;
  chosen_ = number, all_ = false;
  identity_ = {program->host, program->pid};
  emit chosenChanged();
}

void Controls::chooseAll() {
  if (all_) return;
  chosen_.reset(), all_ = true;
  emit chosenChanged();
}

/// `first`: there was no program before.
void Controls::chooseAgain(bool first) {
  if (chosen_ && !find(*chosen_)) {
    chosen_.reset();
    emit chosenChanged();
  }
  if (chosen_ || all_) return;
  for (const Program& program : programs_)
    if (identity_ == std::pair(program.host, program.pid)) return choose(program.number);
  if (first && programs_.size() == 1) choose(programs_.front().number);
}

void Controls::connected() {
  asked_.clear();
  calls_.end("the hub has changed");
  isConnected_ = true;
  observe();
  request({{"type", "list"}});
}

void Controls::disconnected(const QString& why) {
  asked_.clear();
  isConnected_ = false;
  calls_.end("the connection to the hub ended");
  if (!programs_.empty()) takePrograms(json::array());
  emit said(why);
}

void Controls::receiveMessage(const Message& message) {
  const std::string type = textIn(*message, "type");
  if (type == "answer") takeAnswer(*message);
  if (type == "event") takeEvent(*message);
  if (type == "error") {
    const std::string why = textIn(*message, "why");
    emit said(QString::fromStdString(why.empty() ? type : why));
  }
}

void Controls::takeAnswer(const json& answer) {
  const uint64_t id = numberIn<uint64_t>(answer, "id", 0);
  if (calls_.receiveAnswer(id, answer)) return;
  const auto asked = asked_.find(id);
  if (asked == asked_.end()) return;
  const QString what = std::exchange(asked->second, {});
  asked_.erase(asked);
  if (const auto list = answer.find("programs"); list != answer.end()) takePrograms(*list);
  if (what.isEmpty()) return;
  const std::string why = failureOf(answer);
  emit said(QString::fromStdString(why));
  if (!why.empty()) emit settingsChanged();  // editors show the old values again
}

/// The first failure; of several programs with its name.
std::string Controls::failureOf(const json& answer) const {
  if (std::string why = textIn(answer, "why"); !why.empty()) return why;
  const auto results = answer.find("results");
  if (results == answer.end() || !results->is_array()) return "";
  for (const json& result : *results) {
    if (!result.is_object()) continue;
    const std::string why = textIn(result, "why");
    const Program* program = find(numberIn<int>(result, "program", 0));
    if (!why.empty())
      return results->size() > 1 && program ? program->title().toStdString() + ": " + why : why;
  }
  return "";
}

void Controls::takeEvent(const json& event) {
  const std::string what = textIn(event, "what");
  if (what == "programs" && event.contains("programs")) return takePrograms(event["programs"]);
  const int number = numberIn<int>(event, "program", 0);
  if (number <= 0) return;
  Program* program = findMutable(number);
  if (!program) {  // its entry in the list follows
    program = &programs_.emplace_back();
    program->number = number;
  }
  if (what == "settings") takeSettings(*program, event);
  if (what == "state" && event.contains("state")) takeState(*program, event["state"]);
  if (what == "thumbnail") takeThumbnail(*program, event);
}

void Controls::takePrograms(const json& list) {
  std::vector<Program> next;
  for (const json& entry : list) {
    if (!entry.is_object()) continue;
    Program program;
    program.number = numberIn<int>(entry, "program", 0);
    if (const Program* known = find(program.number)) program = *known;
    program.pid = numberIn<int>(entry, "pid", 0);
    program.ranks = numberIn<int>(entry, "ranks", 1);
    program.host = textIn(entry, "host");
    program.name = textIn(entry, "name");
    next.push_back(std::move(program));
  }
  const bool first =
      std::none_of(programs_.begin(), programs_.end(), [](const Program& p) { return p.pid != 0; });
  programs_ = std::move(next);
  std::vector<int> numbers;
  for (const Program& program : programs_) numbers.push_back(program.number);
  calls_.endOthers(numbers, "the program has ended");
  emit programsChanged();
  chooseAgain(first);
  emit settingsChanged();
}

void Controls::takeSettings(Program& program, const json& event) {
  if (const auto values = event.find("values"); values != event.end() && values->is_object())
    for (const auto& [name, entry] : values->items())
      if (entry.is_object() && entry.contains("value"))
        program.values[name] = {entry["value"], textIn(entry, "layer"), textIn(entry, "place")};
  program.undo = numberIn<int>(event, "undo", program.undo);
  program.redo = numberIn<int>(event, "redo", program.redo);
  if (all_ || &program == shown()) emit settingsChanged();
}

void Controls::takeThumbnail(Program& program, const json& event) {
  const int width = numberIn<int>(event, "width", 0), height = numberIn<int>(event, "height", 0);
  const auto bytes = control::fromBase64(textIn(event, "pixels"));
  if (width < 1 || height < 1 || width > kMaxThumbnailPixels || height > kMaxThumbnailPixels || !bytes ||
      bytes->size() != 3 * static_cast<size_t>(width) * static_cast<size_t>(height))
    return;
  const auto* const rows = reinterpret_cast<const uchar*>(bytes->data());
  program.thumbnail = QImage(rows, width, height, 3 * width, QImage::Format_RGB888).copy();
  emit thumbnailChanged(program.number);
}

void Controls::takeState(Program& program, const json& state) {
  if (!state.is_object()) return;
  program.state = state;
  const auto keep = [&](std::deque<double>& values, const char* name, double otherwise) {
    values.push_back(numberIn<double>(state, name, otherwise));
    if (values.size() > kMaxPlottedEvents) values.pop_front();
  };
  keep(program.fps, "fps", 0);
  keep(program.noise, "noise", std::numeric_limits<double>::quiet_NaN());
  keep(program.passes, "passes", std::numeric_limits<double>::quiet_NaN());
  emit stateChanged(program.number);
}

}  // namespace gluray::panel
