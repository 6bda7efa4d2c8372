#include "view/view_window.h"

#include "qt_text.h"
#include "settings/rows.h"
#include "view/look_settings.h"
#include "view/view_widget.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gluray::panel {
namespace {

constexpr int kLine = 15000;  // milliseconds that a line is shown

/// The window is as high as the scene's, if that leaves this much.
void shareHeight(QWidget& list) {
  constexpr int kLeast = 90;  // pixels
  list.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
  list.setMinimumHeight(kLeast);
}

}  // namespace

ViewWindow::ViewWindow(std::unique_ptr<EngineView> view, QString scene, QString gluray, LookOptions look)
    : scene_(std::move(scene)),
      presets_(presetsHere()),
      look_(std::move(look)),
      thread_(std::move(view)),
      widget_(new ViewWidget(thread_, this)),
      step_(new QLabel(this)),
      picture_(std::move(gluray), this) {
  setWindowTitle(tr("%1 - GLuRay").arg(QFileInfo(scene_).fileName()));
  setCentralWidget(widget_);
  statusBar()->addPermanentWidget(step_);
  makeSide();
  makeActions();
  takeLook();
  connect(widget_, &ViewWidget::progressed, this, &ViewWindow::showStep);
  connect(&thread_, &ViewThread::failed, this, &ViewWindow::showLine);
  connect(&picture_, &PictureProcess::done, this, [this](const QString& line, const QString& command) {
    showLine(line);
    if (command.isEmpty())
      emit saveFailed(line);
    else
      emit saved(command);
  });
  const QSize room = screen()->availableSize() * 0.9;
  resize(sizeHint().boundedTo(room));
  widget_->setFocus();
  if (!thread_.facts().movable) showLine(tr("This view cannot be moved: its camera is not known"));
  thread_.start();
}

ViewWindow::~ViewWindow() = default;

void ViewWindow::showLine(const QString& line) { statusBar()->showMessage(line, kLine); }

QWidget* ViewWindow::makeLooks(QWidget* parent) {
  looks_ = new QListWidget(parent);
  looks_->setObjectName("looks");
  shareHeight(*looks_);
  looks_->setAccessibleName(tr("Look"));
  looks_->addItem(tr("as saved"));
  looks_->item(0)->setToolTip(tr("The settings that the program had"));
  looks_->setCurrentRow(0);
  for (const Preset& preset : presets_) {
    if (isQuality(preset)) continue;
    auto* item = new QListWidgetItem(qtText(preset.name), looks_);
    item->setData(Qt::UserRole, qtText(preset.name));
    item->setToolTip(qtText(preset.help));
    if (preset.name == look_.preset) looks_->setCurrentItem(item);
  }
  connect(looks_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    look_.preset = item ? item->data(Qt::UserRole).toString().toStdString() : "";
    takeLook();
  });
  return looks_;
}

QWidget* ViewWindow::makeQualities(QWidget* parent) {
  qualities_ = new QComboBox(parent);
  qualities_->setObjectName("qualities");
  qualities_->addItem(tr("of the look"));
  const Row& row = *findSetting("quality");
  for (size_t i = 1; i < row.words.size(); ++i) {
    qualities_->addItem(qtText(row.words[i].word), qtText(row.words[i].word));
    qualities_->setItemData(qualities_->count() - 1, qtText(row.words[i].help), Qt::ToolTipRole);
  }
  qualities_->setCurrentIndex(std::max(0, qualities_->findData(QString::fromStdString(look_.quality))));
  qualities_->setToolTip(qtText(row.help));
  connect(qualities_, &QComboBox::currentIndexChanged, this, [this](int) {
    look_.quality = qualities_->currentData().toString().toStdString();
    takeLook();
  });
  return qualities_;
}

/// Basic settings, over those of the look.
QWidget* ViewWindow::makeSettings(QWidget* parent) {
  std::map<std::string, std::string> saved;
  const nlohmann::json texts = nlohmann::json::parse(thread_.facts().settings, nullptr, false);
  for (const auto& [name, text] : texts.items())
    if (text.is_string()) saved[name] = text.get<std::string>();
  settings_ = new LookSettings(std::move(saved), parent);
  shareHeight(*settings_);
  connect(settings_, &LookSettings::refused, this, &ViewWindow::showLine);
  connect(settings_, &LookSettings::chosen, this, [this](const std::string& name, const std::string& value) {
    std::erase_if(look_.values, [&](const auto& known) { return known.first == name; });
    if (!value.empty()) look_.values.emplace_back(name, value);
    takeLook();
  });
  return settings_;
}

void ViewWindow::makeSide() {
  auto* dock = new QDockWidget(tr("Look and picture"), this);
  dock->setObjectName("side");
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  auto* inside = new QWidget(dock);
  auto* layout = new QVBoxLayout(inside);
  const auto add = [&](const QString& title, QWidget* widget, int stretch) {
    auto* label = new QLabel(title, inside);
    label->setBuddy(widget);
    layout->addWidget(label);
    layout->addWidget(widget, stretch);
  };
  sizes_ = new QComboBox(inside);
  sizes_->setObjectName("sizes");
  sizes_->setToolTip(tr("Pixels, such as 3840x2160"));
  sizes_->setEditable(true);
  sizes_->addItems({tr("as shown"), "1920x1080", "2560x1440", "3840x2160", "7680x4320"});
  add(tr("&Look"), makeLooks(inside), 2);
  add(tr("&Quality"), makeQualities(inside), 0);
  add(tr("S&ettings"), makeSettings(inside), 3);
  add(tr("Si&ze of saved pictures"), sizes_, 0);
  auto* save = new QPushButton(tr("&Save picture..."), inside);
  save->setToolTip(tr("Saves a picture of this view (Ctrl+S), and prints the command that makes it again"));
  connect(save, &QPushButton::clicked, this, &ViewWindow::askAndSave);
  layout->addWidget(save);
  dock->setWidget(inside);
  addDockWidget(Qt::RightDockWidgetArea, dock);
}

void ViewWindow::makeActions() {
  connect(widget_, &ViewWidget::saveWanted, this, &ViewWindow::askAndSave);
  connect(widget_, &ViewWidget::copyWanted, this, &ViewWindow::copy);
  const auto add = [this](const QList<QKeySequence>& keys, const auto& work) {
    auto* action = new QAction(this);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, work);
    addAction(action);
  };
  add({QKeySequence::Save}, [this] { askAndSave(); });
  add({QKeySequence::Copy}, [this] { copy(); });
  add({QKeySequence::Quit, QKeySequence::Close}, [this] { close(); });
}

void ViewWindow::takeLook() {
  widget_->setSettings(look_.settings(presets_));
  settings_->show(look_, presets_);
}

void ViewWindow::setPreset(const QString& preset) {
  for (int row = 0; row < looks_->count(); ++row)
    if (looks_->item(row)->data(Qt::UserRole).toString() == preset) looks_->setCurrentRow(row);
}

void ViewWindow::setQuality(const QString& quality) {
  qualities_->setCurrentIndex(std::max(0, qualities_->findData(quality)));
}

void ViewWindow::showStep(const ShownView& view) {
  const QSize size = widget_->pixels();
  QStringList parts{QString("%1 x %2").arg(size.width()).arg(size.height())};
  if (view.moving) {
    parts << tr("moving");
  } else {
    parts << (view.passes == 1 ? tr("1 pass") : tr("%1 passes").arg(view.passes));
    if (view.noise > 0)
      parts << (std::isinf(view.noise) ? tr("noise: not known yet")
                                       : tr("noise %1").arg(view.noise, 0, 'f', 4));
    parts << tr("%1 s").arg(view.seconds, 0, 'f', 1);
    parts << (view.finished ? tr("finished") : tr("tracing"));
  }
  step_->setText(parts.join(", "));
}

void ViewWindow::copy() {
  QGuiApplication::clipboard()->setImage(widget_->image());
  showLine(tr("The picture is in the clipboard"));
}

PictureWish ViewWindow::wishFor(const QString& file) const {
  PictureWish wish{.scene = scene_, .file = file, .size = widget_->pixels(), .camera = widget_->camera()};
  wish.saved = thread_.facts().camera;
  wish.look = look_.words();
  const QStringList sides = sizes_->currentText().toLower().split('x');
  if (sizes_->currentIndex() != 0 || sizes_->currentText() != sizes_->itemText(0))
    wish.size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
  return wish;
}

void ViewWindow::save(const QString& file) {
  if (picture_.isBusy()) return showLine(tr("The picture before is not finished yet"));
  const PictureWish wish = wishFor(file);
  if (wish.size.width() < 1 || wish.size.height() < 1) {
    const QString why = tr("%1: use a size such as 3840x2160").arg(sizes_->currentText());
    showLine(why);
    return emit saveFailed(why);
  }
  showLine(tr("Saving %1...").arg(file));
  picture_.start(wish);
}

void ViewWindow::askAndSave() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save picture"), folder_, tr("Pictures (*.png *.exr)"));
  if (file.isEmpty()) return;
  folder_ = QFileInfo(file).path();
  save(QFileInfo(file).suffix().isEmpty() ? file + ".png" : file);
}

}  // namespace gluray::panel
