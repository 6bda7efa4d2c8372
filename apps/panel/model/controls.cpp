#include "model/controls.h"

#include "control/messages/base64.h"
#include "control/messages/value.h"
#include "settings/values.h"

#include <algorithm>
#include <utility>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr size_t kMostFps = 600;        // entries of the plot
constexpr double kStateSeconds = 0.25;  // between events
constexpr int kMostThumbnail = 512;     // pixels of its longest side

/// A member of an object, if it has the type of `otherwise`.
template <class T>
T member(const json& object, const char* name, T otherwise) {
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if constexpr (std::is_same_v<T, std::string>)
    return found->is_string() ? found->get<std::string>() : otherwise;
  else
    return found->is_number() ? found->get<T>() : otherwise;
}

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

json Controls::target() const { return chosen_ ? json(*chosen_) : json("all"); }

void Controls::request(json message, const QString& what) {
  message["id"] = next_;
  asked_[next_++] = what;
  send_(std::move(message));
}

void Controls::set(const std::string& name, const json& value, const std::string& gesture) {
  if (!chosen_ && !all_) return;
  json message{{"type", "set"}, {"program", target()}, {"values", {{name, value}}}};
  if (!gesture.empty()) message["gesture"] = gesture;
  request(std::move(message), QString::fromStdString(name));
}

void Controls::undo() {
  if (chosen_ || all_) request({{"type", "undo"}, {"program", target()}}, tr("undo"));
}

void Controls::redo() {
  if (chosen_ || all_) request({{"type", "redo"}, {"program", target()}}, tr("redo"));
}

void Controls::connected() {
  asked_.clear();
  request({{"type", "observe"},
           {"program", "all"},
           {"what", {"programs", "settings", "state", "thumbnail"}},
           {"every", kStateSeconds}});
  request({{"type", "list"}});
}

void Controls::disconnected(const QString& why) {
  asked_.clear();
  if (!programs_.empty()) takePrograms(json::array());
  emit said(why);
}

void Controls::take(const Message& message) {
  const std::string type = member<std::string>(*message, "type", "");
  if (type == "answer") takeAnswer(*message);
  if (type == "event") takeEvent(*message);
  if (type == "error") emit said(QString::fromStdString(member<std::string>(*message, "why", "error")));
}

void Controls::takeAnswer(const json& answer) {
  const auto asked = asked_.find(member<uint64_t>(answer, "id", 0));
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
  if (std::string why = member<std::string>(answer, "why", ""); !why.empty()) return why;
  const auto results = answer.find("results");
  if (results == answer.end() || !results->is_array()) return "";
  for (const json& result : *results) {
    if (!result.is_object()) continue;
    const std::string why = member<std::string>(result, "why", "");
    const Program* program = find(member<int>(result, "program", 0));
    if (!why.empty())
      return results->size() > 1 && program ? program->title().toStdString() + ": " + why : why;
  }
  return "";
}

void Controls::takeEvent(const json& event) {
  const std::string what = member<std::string>(event, "what", "");
  if (what == "programs" && event.contains("programs")) return takePrograms(event["programs"]);
  const int number = member<int>(event, "program", 0);
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
    program.number = member<int>(entry, "program", 0);
    if (const Program* known = find(program.number)) program = *known;
    program.pid = member<int>(entry, "pid", 0);
    program.ranks = member<int>(entry, "ranks", 1);
    program.host = member<std::string>(entry, "host", "");
    program.name = member<std::string>(entry, "name", "");
    next.push_back(std::move(program));
  }
  const bool first =
      std::none_of(programs_.begin(), programs_.end(), [](const Program& p) { return p.pid != 0; });
  programs_ = std::move(next);
  emit programsChanged();
  chooseAgain(first);
  emit settingsChanged();
}

void Controls::takeSettings(Program& program, const json& event) {
  if (const auto values = event.find("values"); values != event.end() && values->is_object())
    for (const auto& [name, entry] : values->items())
      if (entry.is_object() && entry.contains("value"))
        program.values[name] = {entry["value"], member<std::string>(entry, "layer", ""),
                                member<std::string>(entry, "place", "")};
  program.undo = member<int>(event, "undo", program.undo);
  program.redo = member<int>(event, "redo", program.redo);
  if (all_ || &program == shown()) emit settingsChanged();
}

void Controls::takeThumbnail(Program& program, const json& event) {
  const int width = member<int>(event, "width", 0), height = member<int>(event, "height", 0);
  const auto bytes = control::fromBase64(member<std::string>(event, "pixels", ""));
  if (width < 1 || height < 1 || width > kMostThumbnail || height > kMostThumbnail || !bytes ||
      bytes->size() != 3 * static_cast<size_t>(width) * static_cast<size_t>(height))
    return;
  const auto* const rows = reinterpret_cast<const uchar*>(bytes->data());
  program.thumbnail = QImage(rows, width, height, 3 * width, QImage::Format_RGB888).copy();
  emit thumbnailChanged(program.number);
}

void Controls::takeState(Program& program, const json& state) {
  if (!state.is_object()) return;
  program.state = state;
  program.fps.push_back(member<double>(state, "fps", 0));
  if (program.fps.size() > kMostFps) program.fps.pop_front();
  emit stateChanged(program.number);
}

}  // namespace gluray::panel
