#include "model/object_list.h"

#include "control/messages/members.h"

#include <chrono>
#include <limits>
#include <optional>
#include <utility>

namespace gluray::panel {
namespace {

using control::member, control::textIn, control::wholeNumber;
using nlohmann::json;

constexpr std::chrono::milliseconds kAskAgain{1000};
constexpr std::chrono::milliseconds kFailureIsShown{
    3000};  // for a comparison, nothing is traced for a moment
constexpr size_t kPageOfObjects = 1000;
constexpr size_t kMaxObjects = 20000;   // that are shown
constexpr int kMaxCellCharacters = 64;  // characters
constexpr int kMaxHiddenWords = 16;     // words
constexpr int64_t kMaxNumber = std::numeric_limits<uint32_t>::max();

/// As much as a cell shows.
QString cellText(const json& object, const char* name) {
  return QString::fromStdString(textIn(object, name)).left(kMaxCellCharacters);
}

/// None: it has no number.
std::optional<DrawnObject> objectIn(const json& entry) {
  const auto number = wholeNumber(member(entry, "object"), 1, kMaxNumber);
  if (!number) return std::nullopt;
  DrawnObject object;
  object.number = static_cast<uint32_t>(*number);
  if (!textIn(entry, "color").empty()) object.color = QColor(cellText(entry, "color"));
  object.shape = cellText(entry, "shape");
  object.material = cellText(entry, "material");
  object.triangles = wholeNumber(member(entry, "triangles"), 0, control::kMaxFrame).value_or(0);
  if (const json* hidden = member(entry, "hidden"); hidden && hidden->is_array())
    for (const json& word : *hidden)
      if (word.is_string() && object.hidden.size() < kMaxHiddenWords)
        object.hidden << QString::fromStdString(word.get<std::string>()).left(kMaxCellCharacters);
  return object;
}

}  // namespace

ObjectList::ObjectList(Controls& controls, QObject* parent) : QObject(parent), controls_(controls) {
  timer_.setInterval(kAskAgain);
  connect(&timer_, &QTimer::timeout, this, &ObjectList::ask);
  connect(&controls_, &Controls::chosenChanged, this, &ObjectList::restart);
  connect(&controls_, &Controls::programsChanged, this, [this] {
    if (controls_.chosen().value_or(0) != program_) restart();
  });
}

void ObjectList::watch(bool on) {
  watched_ = on;
  if (!on) return timer_.stop();
  if (controls_.chosen().value_or(0) != program_) restart();
  timer_.start();
  ask();
}

/// Another program is chosen, or none.
void ObjectList::restart() {
  ++round_;
  underWay_ = known_ = false;
  program_ = controls_.chosen().value_or(0);
  objects_.clear();
  version_ = nullptr;
  total_ = 0;
  why_.clear();
  failing_.invalidate();
  emit changed();
  ask();
}

void ObjectList::ask() {
  if (!watched_ || underWay_ || program_ == 0) return;
  underWay_ = true;
  ++round_;
  next_.clear();
  nextVersion_ = nullptr;
  askPage(0);
}

void ObjectList::askPage(uint32_t after) {
  json arguments{{"after", after}, {"count", kPageOfObjects}};
  if (after == 0 && !version_.is_null()) arguments["known"] = version_;
  controls_.call(program_, "objects", std::move(arguments), this,
                 [this, round = round_](const CallAnswer& answer) { receiveAnswer(answer, round); });
}

void ObjectList::receiveAnswer(const CallAnswer& answer, uint64_t round) {
  if (round != round_) return;
  if (!answer.why.empty()) return finish(QString::fromStdString(answer.why));
  const json* const same = member(answer.value, "same");
  if (next_.empty() && control::isTrue(same)) {
    underWay_ = false;
    return;
  }
  const json* const list = member(answer.value, "objects");
  const json* const version = member(answer.value, "version");
  if (!list || !list->is_array() || list->size() > kPageOfObjects)
    return finish(tr("the program's objects cannot be read"));
  const json seen = version ? *version : json();
  // A list whose parts are of different versions is asked for again.
  nextVersion_ = next_.empty() || seen == nextVersion_ ? seen : json();
  const size_t before = next_.size();
  for (const json& entry : *list)
    if (auto object = objectIn(entry); object && (next_.empty() || object->number > next_.back().number))
      next_.push_back(*std::move(object));
  nextTotal_ =
      wholeNumber(member(answer.value, "total"), 0, kMaxNumber).value_or(static_cast<int64_t>(next_.size()));
  const bool more = static_cast<int64_t>(next_.size()) < nextTotal_ && next_.size() > before;
  if (more && next_.size() < kMaxObjects) return askPage(next_.back().number);
  finish({});
}

void ObjectList::finish(const QString& why) {
  underWay_ = false;
  const bool isShown = known_ && why_.isEmpty();
  known_ = true;
  if (!why.isEmpty() && isShown) {
    if (!failing_.isValid()) failing_.start();
    if (!failing_.hasExpired(kFailureIsShown.count())) return next_.clear();
  }
  if (why.isEmpty()) {
    failing_.invalidate();
    objects_ = std::move(next_);
    version_ = std::move(nextVersion_), total_ = nextTotal_;
  } else {
    objects_.clear();
    version_ = nullptr, total_ = 0;
  }
  next_.clear();
  why_ = why;
  emit changed();
}

}  // namespace gluray::panel
