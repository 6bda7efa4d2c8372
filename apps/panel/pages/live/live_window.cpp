#include "pages/live/live_window.h"

#include "pages/live/live_view.h"

#include <QHideEvent>
#include <QLabel>
#include <QShortcut>
#include <QShowEvent>
#include <QVBoxLayout>

namespace gluray::panel {
LiveWindow::LiveWindow(Controls& controls, QWidget* owner)
    : QWidget(owner, Qt::Window),
      controls_(controls),
      view_(new LiveView(controls, this)),
      line_(new QLabel(this)),
      still_(controls, this) {
  setObjectName("live-window");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(view_, 1);
  layout->addWidget(line_);
  line_->setTextFormat(Qt::PlainText);
  line_->setWordWrap(true);
  connect(view_, &LiveView::said, line_, &QLabel::setText);
  view_->isLarge();
  resize(900, 740);
  connect(&still_, &StillImage::changed, this,
          [this](const QImage& image) { view_->liveImage().setStill(image); });
  connect(&controls_, &Controls::chosenChanged, this, &LiveWindow::showTitle);
  connect(&controls_, &Controls::programsChanged, this, &LiveWindow::showTitle);
  connect(new QShortcut(QKeySequence::Cancel, this), &QShortcut::activated, this, &QWidget::close);
  showTitle();
}

LiveWindow::~LiveWindow() { controls_.wantThumbnails(this, 0); }

void LiveWindow::showTitle() {
  const Program* program = controls_.shown();
  setWindowTitle(program ? tr("%1 - GLuRay").arg(program->title()) : tr("GLuRay"));
}

void LiveWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (event->spontaneous()) return;
  controls_.wantThumbnails(this, kMaxThumbnailPixels);
  still_.watch(true);
}

void LiveWindow::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (event->spontaneous()) return;
  controls_.wantThumbnails(this, 0);
  still_.watch(false);
}

}  // namespace gluray::panel
