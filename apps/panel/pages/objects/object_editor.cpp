#include "pages/objects/object_editor.h"

#include "editors/editor.h"
#include "pages/objects/object_entries.h"
#include "qt_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <iterator>
#include <utility>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr const char* kSetting = "material.objects";
constexpr int kFieldColumns = 2;
constexpr int kUntilSaid = 2000;  // milliseconds: a program that has not said by then what it has will not
constexpr size_t kNamed = 6;      // objects in the title

/// material and those of material.* that entries can have.
std::vector<const Row*> fieldRows() {
  std::vector<const Row*> rows;
  for (const Row& row : settingRows())
    if (row.name == "material" || (row.name.starts_with("material.") && row.applies == Applies::frame &&
                                   row.type != Type::path && row.type != Type::list))
      rows.push_back(&row);
  return rows;
}

QString titleOf(const std::vector<DrawnObject>& objects) {
  if (objects.empty()) return ObjectEditor::tr("No object is selected.");
  QStringList numbers;
  for (const DrawnObject& object : objects)
    if (static_cast<size_t>(numbers.size()) < kNamed) numbers << QString::number(object.number);
  if (objects.size() > kNamed) numbers << "...";
  return objects.size() == 1 ? ObjectEditor::tr("Object %1").arg(numbers[0])
                             : ObjectEditor::tr("%1 objects: %2").arg(objects.size()).arg(numbers.join(", "));
}

void setBold(QWidget* widget, bool bold) {
  QFont font = widget->font();
  font.setBold(bold);
  widget->setFont(font);
}

}  // namespace

ObjectEditor::ObjectEditor(Controls& controls, QWidget* parent)
    : QWidget(parent), controls_(controls), movement_(controls, this) {
  auto* layout = new QVBoxLayout(this);
  auto* head = new QHBoxLayout;
  title_ = new QLabel(this);
  title_->setObjectName("objects-title");
  remove_ = new QPushButton(tr("As the program &draws it"), this);
  remove_->setObjectName("objects-remove");
  remove_->setToolTip(
      tr("Resets the selected objects, whether this panel, commands or files have changed them"));
  head->addWidget(title_, 1);
  head->addWidget(remove_);
  layout->addLayout(head);
  auto* grid = new QGridLayout;
  layout->addLayout(grid);
  makeFields(grid);
  layout->addWidget(makeRays());
  layout->addStretch(1);
  connect(remove_, &QPushButton::clicked, this, [this] { change(remove_, {}, false); });
  connect(&controls_, &Controls::said, this, [this](const QString& line) {
    if (!line.isEmpty()) sent_.reset(), update();  // the program may have refused it
  });
  show({});
}

void ObjectEditor::makeFields(QGridLayout* grid) {
  const std::vector<const Row*> rows = fieldRows();
  const int lines = (static_cast<int>(rows.size()) + kFieldColumns - 1) / kFieldColumns;
  for (const Row* row : rows) {
    const int at = static_cast<int>(fields_.size());
    Field& field = fields_.emplace_back();
    field.row = row;
    field.editor = makeEditor(*row, this);
    field.editor->setObjectName("object." + qtText(row->name));
    field.editor->setToolTip(qtText(row->help));
    field.label = new QLabel(qtText(row->title), this);
    field.label->setBuddy(field.editor);
    field.label->setToolTip(qtText(row->help));
    grid->addWidget(field.label, at % lines, 2 * (at / lines));
    grid->addWidget(field.editor, at % lines, 2 * (at / lines) + 1);
    connect(field.editor, &Editor::changed, this,
            [this, row, editor = field.editor](const json& value, bool more) {
              if (const std::string word = wordFor(*row, value); !word.empty()) change(editor, {word}, more);
            });
    connect(field.editor, &Editor::cancelled, this, &ObjectEditor::takeBack);
  }
  for (int column = 0; column < kFieldColumns; ++column) grid->setColumnStretch(2 * column + 1, 1);
}

QWidget* ObjectEditor::makeRays() {
  auto* line = new QWidget(this);
  auto* layout = new QHBoxLayout(line);
  layout->setContentsMargins(0, 0, 0, 0);
  hidden_ = new QLabel(tr("Hidden from rays of"), line);
  layout->addWidget(hidden_);
  static constexpr const char* kTexts[] = {"c&amera", "s&hadow", "&occlusion", "reflec&tion"};
  for (size_t i = 0; i < rays_.size(); ++i) {
    rays_[i] = new QCheckBox(tr(kTexts[i]), line);
    rays_[i]->setObjectName("hidden-from." + qtText(kRayWords[i]));
    rays_[i]->setAccessibleName(tr("Hidden from %1 rays").arg(qtText(kRayWords[i])));
    layout->addWidget(rays_[i]);
    connect(rays_[i], &QCheckBox::clicked, this, &ObjectEditor::changeRays);
  }
  layout->addStretch(1);
  return line;
}

void ObjectEditor::show(std::vector<DrawnObject> objects) {
  const bool same = std::equal(objects.begin(), objects.end(), objects_.begin(), objects_.end(),
                               [](const auto& a, const auto& b) { return a.number == b.number; });
  if (!same) moved_ = nullptr;
  objects_ = std::move(objects);
  setEnabled(!objects_.empty());
  title_->setText(titleOf(objects_));
  update();
}

std::vector<std::string> ObjectEditor::entriesNow() const {
  if (sent_ && sentAt_.elapsed() < kUntilSaid) return *sent_;
  return entriesOf(controls_.value(kSetting).value);
}

json ObjectEditor::valueOf(const Row& row, size_t at, const json& otherwise, bool& said) const {
  if (const auto value = valueIn(words_[at], row)) {
    said = true;
    return *value;
  }
  const QString& material = objects_[at].material;
  return row.name == "material" && !material.isEmpty() ? json(material.toStdString()) : otherwise;
}

QStringList ObjectEditor::hiddenOf(size_t at, bool& said) const {
  const auto rays = raysIn(words_[at]);
  said |= rays.has_value();
  return rays.value_or(objects_[at].hidden);
}

void ObjectEditor::update() {
  if (sent_ && entriesOf(controls_.value(kSetting).value) == *sent_) sent_.reset();
  const ObjectEntries entries(entriesNow());
  words_.clear();
  for (const DrawnObject& object : objects_) words_.push_back(entries.words(object.number));
  for (const Field& field : fields_) showField(field);
  showRays();
  remove_->setEnabled(
      std::any_of(words_.begin(), words_.end(), [](const auto& words) { return !words.empty(); }));
}

void ObjectEditor::showField(const Field& field) {
  bool said = false, differs = false;
  const json otherwise = controls_.value(std::string(field.row->name)).value;
  const json first = objects_.empty() ? otherwise : valueOf(*field.row, 0, otherwise, said);
  for (size_t i = 1; i < objects_.size(); ++i) differs |= valueOf(*field.row, i, otherwise, said) != first;
  if (!field.editor->busy()) field.editor->show(first);
  field.label->setText(qtText(field.row->title) + (differs ? " \u2260" : ""));
  setBold(field.label, said);
}

void ObjectEditor::showRays() {
  std::array<size_t, 4> times{};
  bool said = false;
  for (size_t at = 0; at < objects_.size(); ++at) {
    const QStringList rays = hiddenOf(at, said);
    for (size_t i = 0; i < times.size(); ++i) times[i] += rays.contains(qtText(kRayWords[i]));
  }
  for (size_t i = 0; i < rays_.size(); ++i) {
    const QSignalBlocker quiet(rays_[i]);
    const bool some = times[i] > 0 && times[i] < objects_.size();
    rays_[i]->setTristate(some);
    rays_[i]->setCheckState(some ? Qt::PartiallyChecked : times[i] > 0 ? Qt::Checked : Qt::Unchecked);
  }
  setBold(hidden_, said);
}

/// A kind that only some of the objects are hidden from stays so for each of them.
void ObjectEditor::changeRays() {
  ObjectEntries next(entriesNow());
  for (size_t at = 0; at < objects_.size(); ++at) {
    bool said = false;
    const QStringList had = hiddenOf(at, said);
    QStringList rays;
    for (size_t i = 0; i < rays_.size(); ++i) {
      const Qt::CheckState state = rays_[i]->checkState();
      const QString ray = qtText(kRayWords[i]);
      if (state == Qt::PartiallyChecked ? had.contains(ray) : state == Qt::Checked) rays << ray;
    }
    next.change(objects_[at].number, {wordForRays(rays)});
  }
  send(hidden_, next.all(), false);
}

void ObjectEditor::change(const QObject* editor, const std::vector<std::string>& words, bool more) {
  ObjectEntries next(entriesNow());
  for (const DrawnObject& object : objects_) next.change(object.number, words);
  send(editor, next.all(), more);
}

void ObjectEditor::send(const QObject* editor, std::vector<std::string> next, bool more) {
  if (objects_.empty()) return;
  if (std::exchange(moved_, editor) != editor) movement_.beginNextMovement();
  const Value now = controls_.value(kSetting);
  if (movement_.send({{kSetting, next}}, more)) before_ = now;
  sent_ = std::move(next);
  sentAt_.start();
  update();
}

void ObjectEditor::takeBack() {
  if (!movement_.goesOn()) return;
  sent_.reset();
  movement_.send({{kSetting, before_.layer == "live" ? before_.value : json()}}, false);
}

}  // namespace gluray::panel
