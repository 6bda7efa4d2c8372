#include "pages/live/live_view.h"

#include "model/save_image.h"
#include "model/shot_fetch.h"
#include "pages/film/film_dialog.h"
#include "pages/live/image_call.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QToolButton>

namespace gluray::panel {

LiveView::LiveView(Controls& controls, QWidget* parent)
    : QWidget(parent),
      controls_(controls),
      image_(new LiveImage(controls, this)),
      light_(controls, this),
      comparison_(controls, this) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  makeTools(grid);
  makeButtons(grid);
  layout->addLayout(grid);
  layout->addWidget(image_, 1);
  connect(image_, &LiveImage::pointed, this, &LiveView::point);
  connect(image_, &LiveImage::doubleClicked, this, &LiveView::enlarged);
  connect(&light_, &LightDrag::said, this, &LiveView::said);
  connect(&comparison_, &Comparison::said, this, &LiveView::said);
  connect(&comparison_, &Comparison::changed, this,
          [this] { image_->compare(comparison_.isOn(), comparison_.image()); });
  connect(&controls_, &Controls::chosenChanged, this, &LiveView::enable);
  connect(&controls_, &Controls::programsChanged, this, &LiveView::enable);
  enable();
}

QToolButton* LiveView::addButton(QGridLayout* grid, int row, const char* name, const QString& text,
                                 const QString& key, const QString& help) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(text);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setToolTip(key.isEmpty() ? help : tr("%1 (%2)").arg(help, key));
  button->setAccessibleDescription(help);
  if (!key.isEmpty()) button->setShortcut(QKeySequence(key));
  int column = 0;
  while (grid->itemAtPosition(row, column)) ++column;
  grid->addWidget(button, row, column);
  return button;
}

void LiveView::makeTools(QGridLayout* grid) {
  lightTool_ = addButton(grid, 0, "tool-light", tr("Light"), "L",
                         tr("Drag in the image to move the key light's highlight"));
  focusTool_ = addButton(grid, 0, "tool-focus", tr("Focus"), "F", tr("Click the surface to focus on"));
  compareTool_ =
      addButton(grid, 0, "tool-compare", tr("Compare"), "Ctrl+B",
                tr("The real OpenGL's image left of a divider, which can be dragged or moved by the "
                   "Left and Right keys. For one frame the program's window shows that image"));
  renew_ =
      addButton(grid, 0, "compare-renew", tr("Renew"), "F5",
                tr("Captures the real OpenGL's image again; the program's window shows it for one frame"));
  for (QToolButton* tool : {lightTool_, focusTool_, compareTool_}) tool->setCheckable(true);
  const auto exclude = [](QToolButton* one, QToolButton* other) {
    connect(one, &QToolButton::toggled, other, [other](bool on) {
      if (on) other->setChecked(false);
    });
  };
  exclude(lightTool_, focusTool_);
  exclude(focusTool_, lightTool_);
  connect(compareTool_, &QToolButton::toggled, this, [this](bool on) {
    comparison_.watch(on);
    image_->compare(on, comparison_.image());
    enable();
  });
  connect(renew_, &QToolButton::clicked, &comparison_, &Comparison::renew);
}

void LiveView::makeButtons(QGridLayout* grid) {
  save_ = addButton(grid, 1, "save-image", tr("Save..."), "Ctrl+S",
                    tr("Saves the image of the program's window in full size"));
  save_->setAccessibleName(tr("Save image"));
  film_ = addButton(grid, 1, "film", tr("Film..."), "Ctrl+M", tr("Saves consecutive images"));
  enlarge_ = addButton(grid, 1, "enlarge", tr("Enlarge"), "Ctrl+E",
                       tr("Shows the image in a window of its own; a double click does so, too"));
  connect(save_, &QToolButton::clicked, this, &LiveView::chooseFile);
  connect(enlarge_, &QToolButton::clicked, this, &LiveView::enlarged);
  connect(film_, &QToolButton::clicked, this, [this] {
    auto* dialog = new FilmDialog(controls_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  });
}

void LiveView::isLarge() { enlarge_->hide(), enlarge_->setEnabled(false); }

void LiveView::enable() {
  const bool there = controls_.shown();
  for (QToolButton* button : {lightTool_, focusTool_, compareTool_, save_, film_}) button->setEnabled(there);
  renew_->setEnabled(there && compareTool_->isChecked());
}

void LiveView::point(const ImagePoint& at, LiveImage::Stage stage) {
  if (lightTool_->isChecked()) return light_.point(at, stage);
  if (stage != LiveImage::Stage::release) return;
  if (!focusTool_->isChecked()) return pick(at);
  focusOn(controls_, at, this, [this](const QString& line) { emit said(line); });
}

void LiveView::pick(const ImagePoint& at) {
  pickObject(
      controls_, at, this,
      [this](int program, uint32_t object, const QString& line) {
        emit picked(program, object);
        emit said(line);
      },
      [this](const QString& why) { emit said(why); });
}

void LiveView::chooseFile() {
  auto* dialog = new QFileDialog(this, tr("Save image"), {}, tr("PNG images (*.png)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("png");
  connect(dialog, &QFileDialog::fileSelected, this, &LiveView::saveTo);
  dialog->open();
}

void LiveView::saveTo(const QString& file) {
  const Program* program = controls_.shown();
  if (!program) return;
  emit said(tr("Getting the image..."));
  auto* fetch =
      new ShotFetch(controls_, program->number, this, [this, file](const QImage& image, const QString& why) {
        if (!why.isEmpty()) return void(emit said(tr("No image is saved: %1").arg(why)));
        saveImage(image, file, this, [this, file, size = image.size()](const QString& whyNot) {
          emit said(whyNot.isEmpty() ? tr("%1, %2 x %3").arg(file).arg(size.width()).arg(size.height())
                                     : whyNot);
        });
      });
  fetch->shoot();
}

}  // namespace gluray::panel
