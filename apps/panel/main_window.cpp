#include "main_window.h"

#include "pages/fps_plot.h"
#include "pages/layout.h"
#include "pages/live_picture.h"
#include "pages/program_list.h"
#include "pages/settings_page.h"
#include "pages/why_page.h"
#include "qt_text.h"
#include "settings/layers.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QVBoxLayout>

namespace gluray::panel {

MainWindow::MainWindow(Controls& controls) : controls_(controls) {
  setWindowTitle(tr("GLuRay"));
  auto* splitter = new QSplitter(this);
  splitter->addWidget(makePrograms());
  splitter->addWidget(makePages());
  splitter->setStretchFactor(1, 1);
  setCentralWidget(splitter);
  makeToolBar();
  connect(&controls_, &Controls::settingsChanged, this, &MainWindow::showSettings);
  connect(&controls_, &Controls::chosenChanged, this, &MainWindow::showSettings);
  connect(&controls_, &Controls::programsChanged, this, &MainWindow::showSettings);
  connect(&controls_, &Controls::stateChanged, this, &MainWindow::showState);
  connect(&controls_, &Controls::said, this, [this](const QString& line) { statusBar()->showMessage(line); });
  connect(&controls_, &Controls::programsChanged, this, &MainWindow::greet);
  connect(&controls_, &Controls::chosenChanged, this, &MainWindow::greet);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { why_->show(controls_.shown()); });
  resize(980, 760);
  showSettings();
  greet();
}

void MainWindow::greet() {
  QString line;
  if (controls_.programs().empty())
    line = tr("No program runs under GLuRay; start one with: gluray PROGRAM");
  else if (!controls_.shown())
    line = tr("Choose a program on the left");
  statusBar()->showMessage(line);
}

QWidget* MainWindow::makePrograms() {
  auto* side = new QWidget(this);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new ProgramList(controls_, side), 1);
  layout->addWidget(new LivePicture(controls_, side), 1);
  layout->addWidget(new FpsPlot(controls_, side));
  return side;
}

QWidget* MainWindow::makePages() {
  tabs_ = new QTabWidget(this);
  for (const Page& page : pages()) {
    pages_.push_back(new SettingsPage(page, controls_, tabs_));
    titles_.push_back(QString::fromStdString(page.title));
    tabs_->addTab(pages_.back(), titles_.back());
  }
  why_ = new WhyPage(tabs_);
  tabs_->addTab(why_, tr("Why"));
  return tabs_;
}

void MainWindow::makeToolBar() {
  auto* bar = addToolBar(tr("Controls"));
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  undo_ = bar->addAction(tr("Undo"), &controls_, [this] { controls_.undo(); });
  undo_->setShortcut(QKeySequence::Undo);
  redo_ = bar->addAction(tr("Redo"), &controls_, [this] { controls_.redo(); });
  redo_->setShortcut(QKeySequence::Redo);
  bar->addSeparator();
  makePresets();
  auto* label = new QLabel(tr("&Preset "), bar);
  label->setBuddy(presets_);
  bar->addWidget(label);
  bar->addWidget(presets_);
  bar->addSeparator();
  search_ = new QLineEdit(bar);
  search_->setObjectName("search");
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search settings"));
  search_->setMaximumWidth(fontMetrics().averageCharWidth() * 40);
  bar->addWidget(search_);
  changedOnly_ = new QCheckBox(tr("&Changed only"), bar);
  changedOnly_->setObjectName("changed");
  bar->addWidget(changedOnly_);
  connect(search_, &QLineEdit::textChanged, this, &MainWindow::filter);
  connect(changedOnly_, &QCheckBox::toggled, this, &MainWindow::filter);
  auto* find = new QAction(this);
  find->setShortcut(QKeySequence::Find);
  connect(find, &QAction::triggered, search_, [this] { search_->setFocus(), search_->selectAll(); });
  addAction(find);
}

void MainWindow::makePresets() {
  presets_ = new QComboBox(this);
  presets_->setObjectName("presets");
  presets_->setAccessibleName(tr("Preset"));
  presets_->setMinimumContentsLength(12);
  presets_->addItem(QString::fromUtf8(kNoPreset.data()));
  presets_->setItemData(0, tr("What files and options say."), Qt::ToolTipRole);
  const Sources sources = sourcesOfProcess();
  for (const Preset& preset : presetsOf(readConfigFiles(sources, [](const std::string&) {}))) {
    presets_->addItem(QString::fromStdString(preset.name));
    presets_->setItemData(presets_->count() - 1, QString::fromStdString(preset.help), Qt::ToolTipRole);
  }
  connect(presets_, &QComboBox::activated, this,
          [this](int i) { controls_.set("preset", presets_->itemText(i).toStdString()); });
}

void MainWindow::showSettings() {
  const Program* program = controls_.shown();
  for (SettingsPage* page : pages_) page->widget()->setEnabled(program), page->update();
  presets_->setEnabled(program);
  undo_->setEnabled(controls_.undoSteps() > 0);
  redo_->setEnabled(controls_.redoSteps() > 0);
  const nlohmann::json preset = controls_.value("preset").value;
  const QString name = preset.is_string() ? QString::fromStdString(preset.get<std::string>()) : "";
  presets_->setCurrentIndex(name.isEmpty() ? 0 : presets_->findText(name));
  why_->show(program);
  if (changedOnly_->isChecked()) filter();
}

void MainWindow::showState(int program) {
  const Program* shown = controls_.shown();
  if (shown && shown->number == program && why_->isVisible()) why_->show(shown);
}

void MainWindow::filter() {
  const bool filters = !search_->text().isEmpty() || changedOnly_->isChecked();
  int best = -1;
  for (size_t i = 0; i < pages_.size(); ++i) {
    const int left = pages_[i]->filter(search_->text(), changedOnly_->isChecked());
    const int tab = static_cast<int>(i);
    tabs_->setTabText(tab, filters ? titles_[i] + " (" + QString::number(left) + ")" : titles_[i]);
    if (left > 0 && (best < 0 || tab == tabs_->currentIndex())) best = tab;
  }
  if (filters && best >= 0 && tabs_->currentIndex() < static_cast<int>(pages_.size()))
    tabs_->setCurrentIndex(best);
}

}  // namespace gluray::panel
