#include "main_window.h"

#include "drop_files.h"
#include "model/comparison.h"
#include "model/film.h"
#include "pages/layout.h"
#include "pages/light/light_panel.h"
#include "pages/live/live_view.h"
#include "pages/live/live_window.h"
#include "pages/objects/objects_page.h"
#include "pages/plots/plot.h"
#include "pages/program_list.h"
#include "pages/settings_page.h"
#include "pages/why_page.h"
#include "qt_text.h"
#include "settings/layers/settings_layers.h"

#include <QAction>
#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QVBoxLayout>

namespace gluray::panel {
namespace {

constexpr const char* kTitle = "page-title";  // property of a page: its tab's text without a number
constexpr int kWidth = 1200, kHeight = 800;   // pixels: all tabs fit
constexpr int kSide = 290;                    // pixels: width of the list of programs
constexpr int kToolLine = 12000;              // milliseconds

}  // namespace

MainWindow::MainWindow(Controls& controls) : controls_(controls) {
  setWindowTitle(tr("GLuRay"));
  resize(kWidth, kHeight);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(makePrograms());
  splitter->addWidget(makePages());
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({kSide, width()});
  setCentralWidget(splitter);
  makeToolBar();
  connect(&controls_, &Controls::settingsChanged, this, &MainWindow::showSettings);
  connect(&controls_, &Controls::chosenChanged, this, &MainWindow::showSettings);
  connect(&controls_, &Controls::programsChanged, this, &MainWindow::showSettings);
  connect(&controls_, &Controls::stateChanged, this, &MainWindow::showState);
  connect(&controls_, &Controls::said, this, [this](const QString& line) { say(line, false); });
  connect(&controls_, &Controls::programsChanged, this, &MainWindow::greet);
  connect(&controls_, &Controls::chosenChanged, this, &MainWindow::greet);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { why_->show(controls_.shown()); });
  setAcceptDrops(true);
  for (QLineEdit* line : findChildren<QLineEdit*>()) line->setAcceptDrops(false);  // the window takes files
  showSettings();
  greet();
}

MainWindow::~MainWindow() = default;

void MainWindow::closeEvent(QCloseEvent* event) {
  // Those of the large window, too, and of dialogs.
  for (Film* film : findChildren<Film*>()) film->stop();
  for (Comparison* comparison : findChildren<Comparison*>()) comparison->watch(false);
  QMainWindow::closeEvent(event);
}

void MainWindow::say(const QString& line, bool ofTool) {
  if (line.isEmpty() && toolSpoke_ && !statusBar()->currentMessage().isEmpty()) return;
  toolSpoke_ = ofTool;
  statusBar()->showMessage(line, ofTool ? kToolLine : 0);
}

void MainWindow::greet() {
  QString line;
  if (controls_.programs().empty())
    line = tr("No program runs under GLuRay; start one with: gluray PROGRAM");
  else if (!controls_.shown())
    line = tr("Choose a program on the left");
  say(line, false);
}

QWidget* MainWindow::makePrograms() {
  auto* side = new QWidget(this);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(4, 4, 0, 4);
  auto* view = new LiveView(controls_, side);
  listenTo(*view);
  connect(view, &LiveView::enlarged, this, &MainWindow::enlarge);
  layout->addWidget(new ProgramList(controls_, side), 2);
  layout->addWidget(view, 3);
  layout->addWidget(new FpsPlot(controls_, side));
  layout->addWidget(new NoisePlot(controls_, side));
  return side;
}

void MainWindow::listenTo(LiveView& view) {
  connect(&view, &LiveView::said, this, [this](const QString& line) { say(line, true); });
  connect(&view, &LiveView::picked, this, &MainWindow::showPicked);
}

void MainWindow::showPicked(int program, uint32_t object) {
  if (controls_.chosen() != program) return;  // the page shows the objects of one program
  objects_->select(object);
  if (object > 0) tabs_->setCurrentWidget(objects_);
}

void MainWindow::enlarge() {
  if (!large_) {
    large_ = new LiveWindow(controls_, this);
    listenTo(large_->view());
  }
  large_->show();
  large_->raise();
  large_->activateWindow();
}

QWidget* MainWindow::makePages() {
  tabs_ = new QTabWidget(this);
  const auto add = [this](QWidget* page, const QString& title) {
    page->setProperty(kTitle, title);
    tabs_->addTab(page, title);
  };
  for (const Page& page : pages()) {
    pages_.push_back(new SettingsPage(page, controls_, tabs_));
    add(pages_.back(), QString::fromStdString(page.title));
    if (page.title == "Light") {
      light_ = new LightPanel(controls_, pages_.back());
      pages_.back()->setTop(light_);
      connect(light_, &LightPanel::said, this, [this](const QString& line) { say(line, true); });
    }
    if (page.title == "Materials") add(objects_ = new ObjectsPage(controls_, tabs_), tr("Objects"));
  }
  add(why_ = new WhyPage(tabs_), tr("Why"));
  return tabs_;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  for (const QUrl& url : event->mimeData()->urls())
    takeFile(url.isLocalFile() ? url.toLocalFile() : url.toString());
}

void MainWindow::takeFile(const QString& file) {
  if (!controls_.shown()) return say(tr("Choose a program before you drop a file"), true);
  const DropMeaning meaning = meaningOf(file);
  if (!meaning.why.isEmpty()) return say(meaning.why, true);
  QStringList parts;
  for (const auto& [name, value] : meaning.values.items())
    parts << QString::fromStdString(name + " = " + value.get<std::string>());
  say(parts.join(", "), true);
  controls_.change(meaning.values);
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
  presets_->setItemData(0, tr("No preset: the values from files and options."), Qt::ToolTipRole);
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
  for (SettingsPage* page : pages_) page->setUsable(program), page->update();
  light_->update();
  objects_->update();
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
  const QString search = search_->text();
  const bool changed = changedOnly_->isChecked(), filters = !search.isEmpty() || changed;
  std::vector<QWidget*> empty;
  const auto show = [&](QWidget* page, int left) {
    const QString title = page->property(kTitle).toString();
    tabs_->setTabText(tabs_->indexOf(page), filters ? title + " (" + QString::number(left) + ")" : title);
    tabs_->setTabVisible(tabs_->indexOf(page), true);
    if (filters && left == 0) empty.push_back(page);
  };
  SettingsPage* best = nullptr;
  bool current = false;  // a page of settings is shown
  for (SettingsPage* page : pages_) {
    const int left = page->filter(search, changed);
    show(page, left);
    current |= page == tabs_->currentWidget();
    if (left > 0 && (!best || page == tabs_->currentWidget())) best = page;
  }
  show(objects_, objects_->filter(search));
  if (filters && best && current) tabs_->setCurrentWidget(best);
  for (QWidget* page : empty)
    if (page != tabs_->currentWidget()) tabs_->setTabVisible(tabs_->indexOf(page), false);
}

}  // namespace gluray::panel
