#include "pages/program_list.h"

#include <QHeaderView>
#include <QPainter>
#include <QSignalBlocker>
#include <cmath>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr int kNumber = Qt::UserRole;  // of the program; 0: all
constexpr int kFps = 1, kTriangles = 2;
constexpr QSize kIcon(48, 36);

double number(const json& state, const char* name) {
  const auto found = state.find(name);
  return found != state.end() && found->is_number() ? found->get<double>() : 0;
}

/// "1.2 M".
QString shortNumber(double value) {
  static constexpr const char* kUnits[] = {"", " k", " M", " G"};
  int unit = 0;
  while (value >= 999.5 && unit < 3) value /= 1000, ++unit;
  return QString::number(value, 'f', unit > 0 && value < 99.5 ? 1 : 0) + kUnits[unit];
}

/// The image in the middle of an icon, which has the same size for all programs.
QIcon iconOf(const QImage& image, qreal dots) {
  const QSize size = kIcon * dots;
  QPixmap icon(size);
  icon.fill(Qt::transparent);
  const QImage small = image.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  QPainter(&icon).drawImage((size.width() - small.width()) / 2, (size.height() - small.height()) / 2, small);
  icon.setDevicePixelRatio(dots);
  return icon;
}

}  // namespace

ProgramList::ProgramList(Controls& controls, QWidget* parent) : QTreeWidget(parent), controls_(controls) {
  setHeaderLabels({tr("Program"), tr("fps"), tr("Triangles")});
  for (const int column : {kFps, kTriangles})
    headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  setRootIsDecorated(false);
  setAllColumnsShowFocus(true);
  setAccessibleName(tr("Programs"));
  setIconSize(kIcon);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(kFps, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kTriangles, QHeaderView::ResizeToContents);
  connect(&controls_, &Controls::programsChanged, this, &ProgramList::fill);
  connect(&controls_, &Controls::chosenChanged, this, &ProgramList::mark);
  connect(&controls_, &Controls::stateChanged, this, &ProgramList::showState);
  connect(&controls_, &Controls::thumbnailChanged, this, &ProgramList::showThumbnail);
  connect(this, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (selectedItems().isEmpty()) return;
    const int program = selectedItems().first()->data(0, kNumber).toInt();
    program ? controls_.choose(program) : controls_.chooseAll();
  });
  fill();
}

void ProgramList::fill() {
  const QSignalBlocker quiet(this);
  clear();
  if (controls_.programs().size() != 1 || controls_.all()) {
    auto* all =
        new QTreeWidgetItem(this, {controls_.programs().empty() ? tr("No program") : tr("All programs")});
    all->setData(0, kNumber, 0);
  }
  for (const Program& program : controls_.programs()) {
    auto* item = new QTreeWidgetItem(this, {program.title()});
    item->setData(0, kNumber, program.number);
    item->setToolTip(0, QString::fromStdString(program.host));
    for (const int column : {kFps, kTriangles})
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    showState(program.number);
    showThumbnail(program.number);
  }
  mark();
}

void ProgramList::mark() {
  const QSignalBlocker quiet(this);
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (const int number = topLevelItem(i)->data(0, kNumber).toInt();
        number ? controls_.chosen() == number : controls_.all())
      setCurrentItem(topLevelItem(i));
}

void ProgramList::showState(int number_) {
  const Program* program = controls_.find(number_);
  for (int i = 0; program && i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    if (item->data(0, kNumber).toInt() != number_ || program->state.empty()) continue;
    const double fps = number(program->state, "fps");
    item->setText(kFps, fps > 0 ? QString::number(fps, 'f', fps < 10 ? 1 : 0) : tr("idle"));
    item->setText(kTriangles, shortNumber(number(program->state, "triangles")));
  }
}

void ProgramList::showThumbnail(int number_) {
  const Program* program = controls_.find(number_);
  for (int i = 0; program && !program->thumbnail.isNull() && i < topLevelItemCount(); ++i)
    if (topLevelItem(i)->data(0, kNumber).toInt() == number_)
      topLevelItem(i)->setIcon(0, iconOf(program->thumbnail, devicePixelRatioF()));
}

}  // namespace gluray::panel
