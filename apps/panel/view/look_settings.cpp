#include "view/look_settings.h"

#include "control/messages/value.h"
#include "editors/editor.h"
#include "qt_text.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace gluray::panel {
namespace {

/// Those that look and quality are made of. What they choose themselves stands beside.
bool isShown(const Row& row) {
  return row.level == Level::basic && row.changes == Changes::image && row.name != "preset" &&
         row.name != "quality";
}

}  // namespace

LookSettings::LookSettings(std::map<std::string, std::string> saved, QWidget* parent)
    : QScrollArea(parent), saved_(std::move(saved)) {
  setObjectName("settings");
  setAccessibleName(tr("Settings"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget(this);
  auto* layout = new QVBoxLayout(inside);
  for (const std::string_view group : settingGroups())
    for (const Row* row : rowsOfGroup(group))
      if (isShown(*row)) add(*row, inside);
  layout->addStretch(1);
  setWidget(inside);
  setMinimumWidth(inside->minimumSizeHint().width() + 24);  // and a scroll bar
}

void LookSettings::add(const Row& row, QWidget* inside) {
  const Line line{&row, new QLabel(qtText(row.title), inside), makeEditor(row, inside),
                  new QToolButton(inside)};
  line.label->setBuddy(line.editor);
  line.label->setToolTip(qtText(row.help));
  line.editor->setToolTip(qtText(row.help));
  line.reset->setText("\u21ba");
  line.reset->setAutoRaise(true);
  line.reset->setToolTip(tr("The value of the look"));
  line.reset->setAccessibleName(tr("Reset %1").arg(qtText(row.title)));
  auto* head = new QHBoxLayout;
  head->addWidget(line.label, 1);
  head->addWidget(line.reset);
  auto* layout = qobject_cast<QVBoxLayout*>(inside->layout());
  layout->addLayout(head);
  layout->addWidget(line.editor);
  const std::string name(row.name);
  connect(line.reset, &QToolButton::clicked, this, [this, name] { emit chosen(name, ""); });
  connect(line.editor, &Editor::changed, this, [this, &row, name](const nlohmann::json& value, bool) {
    const control::TextOrWhy text = control::textOf(row, value);
    if (text.why.empty())
      emit chosen(name, text.text);
    else
      emit refused(QString::fromStdString(name + ": " + text.why));
  });
  lines_.push_back(line);
}

void LookSettings::show(const LookOptions& look, const std::vector<Preset>& presets) {
  std::map<std::string, std::string> values = saved_;
  for (const std::string& text : look.settings(presets))
    values[text.substr(0, text.find('='))] = text.substr(text.find('=') + 1);
  for (const Line& line : lines_) {
    const std::string name(line.row->name);
    const bool own =
        std::any_of(look.values.begin(), look.values.end(), [&](const auto& v) { return v.first == name; });
    QFont font = line.label->font();
    font.setBold(own);
    line.label->setFont(font);
    line.reset->setEnabled(own);
    if (!line.editor->busy()) line.editor->show(control::valueOf(*line.row, values[name]));
  }
}

}  // namespace gluray::panel
