#include "pages/light/light_list.h"

#include "control/messages/members.h"
#include "pages/tree_rows.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace gluray::panel {
namespace {

using control::member, control::textIn;
using nlohmann::json;

constexpr int kFirstNumber = 4;  // column
constexpr size_t kMaxLights = 256;
constexpr int kMaxText = 64;  // characters of a cell

QString numberText(const json& light, const char* name) {
  const json* const value = member(light, name);
  return value && value->is_number() ? QString::number(value->get<double>(), 'g', 3) : QString();
}

QString lightText(const json& light, const char* name) {
  return QString::fromStdString(textIn(light, name)).left(kMaxText);
}

QStringList rowOf(const json& light) {
  return {lightText(light, "name"),     lightText(light, "from"),     lightText(light, "kind"),
          lightText(light, "color"),    numberText(light, "azimuth"), numberText(light, "elevation"),
          numberText(light, "strength")};
}

}  // namespace

LightList::LightList(Controls& controls, QWidget* parent)
    : QWidget(parent),
      poll_(controls, "lights", this),
      message_(new QLabel(this)),
      lights_(new QTreeWidget(this)) {
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  lights_->setObjectName("lights-list");
  lights_->setHeaderLabels(
      {tr("Light"), tr("From"), tr("Kind"), tr("Colour"), tr("Azimuth"), tr("Elevation"), tr("Strength")});
  for (int column = kFirstNumber; column < lights_->columnCount(); ++column)
    lights_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  lights_->setRootIsDecorated(false);
  lights_->setAllColumnsShowFocus(true);
  lights_->setAccessibleName(tr("Lights"));
  lights_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  lights_->header()->setStretchLastSection(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(message_);
  layout->addWidget(lights_, 1);
  connect(&poll_, &Poll::answered, this, &LightList::receiveAnswer);
  connect(&poll_, &Poll::restarted, this, [this] { say(""); });
  say("");
}

QSize LightList::sizeHint() const { return {320, fontMetrics().height() * 8}; }

void LightList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  poll_.watch(true);
}

void LightList::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  poll_.watch(false);
}

/// A line in place of the list.
void LightList::say(const QString& line) {
  message_->setText(line);
  message_->setVisible(!line.isEmpty());
  setRows(*lights_, {});
}

void LightList::receiveAnswer(const CallAnswer& answer) {
  const json* const list = member(answer.value, "lights");
  if (!answer.why.empty()) return say(tr("No list of lights: %1").arg(QString::fromStdString(answer.why)));
  if (!list || !list->is_array()) return say(tr("The program's lights cannot be read."));
  std::vector<QStringList> rows;
  for (const json& light : *list)
    if (light.is_object() && rows.size() < kMaxLights) rows.push_back(rowOf(light));
  message_->setVisible(rows.empty());
  if (rows.empty()) message_->setText(tr("No light shines on the traced objects."));
  setRows(*lights_, rows);
  for (int i = 0; i < lights_->topLevelItemCount(); ++i) {
    const QColor color(lights_->topLevelItem(i)->text(3));
    lights_->topLevelItem(i)->setData(3, Qt::DecorationRole, color.isValid() ? QVariant(color) : QVariant());
  }
}

}  // namespace gluray::panel
