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
  remove_->setToolTip(tr("Takes back what this panel, commands and files say of the selected objects"));
  head->addWidget(title_, 1);
  head->addWidget(remove_);
  layout->addLayout(head);
  auto* grid = new QGridLayout;
  layout->addLayout(grid);
  makeFields(grid);
  layout->addWidget(makeRays());
  layout->addStretch(1);
  connect(remove_, &QPushButton::clicked, this, [this] { change({}, false); });
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
    field.label = new QLabel(qtText(row->name.substr(row->name.find('.') + 1)), this);
    field.label->setBuddy(field.editor);
    field.label->setToolTip(qtText(row->help));
    grid->addWidget(field.label, at % lines, 2 * (at / lines));
    grid->addWidget(field.editor, at % lines, 2 * (at / lines) + 1);
    connect(field.editor, &Editor::changed, this, [this, row](const json& value, bool more) {
      if (const std::string word = wordFor(*row, value); !word.empty()) change({word}, more);
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
  objects_ = std::move(objects);
  setEnabled(!objects_.empty());
  title_->setText(titleOf(objects_));
  update();
}

std::vector<std::string> ObjectEditor::entries() const {
  if (sent_ && sentAt_.elapsed() < kUntilSaid) return *sent_;
  return entriesOf(controls_.value(kSetting).value);
}

json ObjectEditor::valueOf(const Row& row, const DrawnObject& object, bool& said) const {
  const auto value = valueIn(wordsOf(entries(), object.number), row);
  said = value.has_value();
  if (value) return *value;
  if (row.name == "material" && !object.material.isEmpty()) return object.material.toStdString();
  return controls_.value(std::string(row.name)).value;
}

QStringList ObjectEditor::hiddenOf(const DrawnObject& object, bool& said) const {
  const auto rays = raysIn(wordsOf(entries(), object.number));
  said = rays.has_value();
  return rays.value_or(object.hidden);
}

void ObjectEditor::update() {
  if (sent_ && entriesOf(controls_.value(kSetting).value) == *sent_) sent_.reset();
  for (const Field& field : fields_) showField(field);
  showRays();
  remove_->setEnabled(std::any_of(objects_.begin(), objects_.end(), [&](const DrawnObject& object) {
    return !wordsOf(entries(), object.number).empty();
  }));
}

void ObjectEditor::showField(const Field& field) {
  bool said = false, differs = false;
  const json first = objects_.empty() ? controls_.value(std::string(field.row->name)).value
                                      : valueOf(*field.row, objects_[0], said);
  for (const DrawnObject& object : objects_) {
    bool alsoSaid = false;
    differs |= valueOf(*field.row, object, alsoSaid) != first;
    said |= alsoSaid;
  }
  if (!field.editor->busy()) field.editor->show(first);
  field.label->setText(qtText(field.row->name.substr(field.row->name.find('.') + 1)) +
                       (differs ? " \u2260" : ""));
  setBold(field.label, said);
}

void ObjectEditor::showRays() {
  std::array<size_t, 4> times{};
  bool said = false;
  for (const DrawnObject& object : objects_) {
    bool alsoSaid = false;
    const QStringList rays = hiddenOf(object, alsoSaid);
    said |= alsoSaid;
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
  std::vector<std::string> next = entries();
  for (const DrawnObject& object : objects_) {
    bool said = false;
    const QStringList had = hiddenOf(object, said);
    QStringList rays;
    for (size_t i = 0; i < rays_.size(); ++i) {
      const Qt::CheckState state = rays_[i]->checkState();
      const QString ray = qtText(kRayWords[i]);
      if (state == Qt::PartiallyChecked ? had.contains(ray) : state == Qt::Checked) rays << ray;
    }
    next = withObject(std::move(next), object.number, {wordForRays(rays)});
  }
  send(std::move(next), false);
}

void ObjectEditor::change(const std::vector<std::string>& words, bool more) {
  std::vector<std::string> next = entries();
  for (const DrawnObject& object : objects_) next = withObject(std::move(next), object.number, words);
  send(std::move(next), more);
}

void ObjectEditor::send(std::vector<std::string> next, bool more) {
  if (objects_.empty()) return;
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
