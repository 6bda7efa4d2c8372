#include "pages/setting_row.h"

#include "control/messages/value.h"
#include "editors/editor.h"
#include "qt_text.h"
#include "settings/values.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace gluray::panel {
namespace {

constexpr const char* kDiffers = " \u2260";

QString helpOf(const Row& row) {
  QString text = "<p><b>" + qtText(row.title).toHtmlEscaped() + "</b> (<code>" +
                 qtText(row.name).toHtmlEscaped() + "</code>)</p><p>" + qtText(row.help).toHtmlEscaped() +
                 " " + qtText(row.more).toHtmlEscaped() + "</p>";
  if (const std::string values = allowedValues(row); !values.empty())
    text +=
        "<p>" + SettingRow::tr("Values: %1.").arg(QString::fromStdString(values).toHtmlEscaped()) + "</p>";
  for (const Word& word : row.words)
    text += "<p><i>" + qtText(word.word) + "</i>: " + qtText(word.help).toHtmlEscaped() + "</p>";
  return text;
}

}  // namespace

SettingRow::SettingRow(const Row& row, Controls& controls, QWidget* parent)
    : QWidget(parent),
      row_(row),
      controls_(controls),
      label_(new QLabel(qtText(row.title), this)),
      editor_(makeEditor(row, this)),
      reset_(new QToolButton(this)),
      movement_(controls, this) {
  label_->setBuddy(editor_);
  label_->setToolTip(helpOf(row));
  editor_->setToolTip(helpOf(row));
  reset_->setText("\u21ba");
  reset_->setAutoRaise(true);
  reset_->setAccessibleName(tr("Reset %1").arg(qtText(row.title)));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(label_);
  layout->addWidget(editor_, 1);
  layout->addWidget(reset_);
  connect(editor_, &Editor::changed, this, &SettingRow::send);
  connect(editor_, &Editor::cancelled, this, &SettingRow::takeBack);
  connect(reset_, &QToolButton::clicked, this, [this] { controls_.set(std::string(row_.name), nullptr); });
  update();
}

int SettingRow::widestLabel() const {
  QFont bold = label_->font();
  bold.setBold(true);
  return QFontMetrics(bold).horizontalAdvance(qtText(row_.title) + kDiffers);
}

void SettingRow::setLabelWidth(int width) { label_->setFixedWidth(width); }

void SettingRow::update() {
  const std::string name(row_.name);
  const Value now = controls_.value(name);
  const nlohmann::json builtIn = control::valueOf(row_, printValue(row_, Session{}));
  changed_ = now.value != builtIn;
  if (!editor_->busy()) editor_->show(now.value);
  QFont font = label_->font();
  font.setBold(changed_);
  label_->setFont(font);
  label_->setText(qtText(row_.title) + (controls_.differs(name) ? kDiffers : ""));
  const QString from = now.place.empty() ? QString::fromStdString(now.layer)
                                         : QString::fromStdString(now.layer + ": " + now.place);
  reset_->setEnabled(controls_.isLive(name));
  reset_->setToolTip(now.layer == "live" ? tr("Back to what files and options say")
                                         : tr("Value from: %1").arg(from));
}

void SettingRow::send(const nlohmann::json& value, bool more) {
  const Value now = controls_.value(std::string(row_.name));
  if (movement_.send({{std::string(row_.name), value}}, more)) before_ = now;
}

void SettingRow::takeBack() {
  if (!movement_.goesOn()) return;  // nothing was sent
  const bool live = before_.layer == "live";
  send(live ? before_.value : nlohmann::json(), false);
}

}  // namespace gluray::panel
