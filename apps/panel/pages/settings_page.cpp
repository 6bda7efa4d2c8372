#include "pages/settings_page.h"

#include "panel_memory.h"

#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace gluray::panel {
namespace {

constexpr int kScrollBar = 24;  // pixels

QString headingOf(Level level) {
  return level == Level::advanced ? SettingsPage::tr("Advanced")
         : level == Level::expert ? SettingsPage::tr("Expert")
                                  : QString();
}

/// Of the page's state in the panel's memory.
QString keyOf(const QString& page) { return "more/" + page; }

}  // namespace

SettingsPage::SettingsPage(const Page& page, Controls& controls, QWidget* parent)
    : QScrollArea(parent), controls_(controls), title_(QString::fromStdString(page.title)) {
  auto* inside = new QWidget(this);
  layout_ = new QVBoxLayout(inside);
  setWidget(inside);
  const bool hasBasic = page.sections.front().level == Level::basic;
  size_t others = 0;
  for (const Section& section : page.sections)
    if (section.level != Level::basic) others += section.rows.size();
  for (const Section& section : page.sections) {
    if (hasBasic && !more_ && section.level != Level::basic) addMore(others);
    addSection(section);
  }
  layout_->addStretch(1);
  alignLabels();
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(inside->minimumSizeHint().width() + kScrollBar);
  if (more_) showMore(PanelMemory().value(keyOf(title_), false).toBool());
}

void SettingsPage::addSection(const Section& section) {
  auto* box = new QGroupBox(headingOf(section.level), widget());
  new QVBoxLayout(box);
  layout_->addWidget(box);
  boxes_.push_back({section.level, box, {}});
  for (const Row* row : section.rows) {
    boxes_.back().rows.push_back(new SettingRow(*row, controls_, box));
    box->layout()->addWidget(boxes_.back().rows.back());
  }
}

void SettingsPage::addMore(size_t settings) {
  more_ = new QToolButton(widget());
  more_->setObjectName("more");
  more_->setText(tr("More settings (%1)").arg(settings));
  more_->setToolTip(tr("Shows advanced and expert settings of this page"));
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more_->setFocusPolicy(Qt::StrongFocus);
  more_->setCheckable(true);
  more_->setAutoRaise(true);
  layout_->addWidget(more_);
  connect(more_, &QToolButton::toggled, this, [this](bool shown) {
    PanelMemory().setValue(keyOf(title_), shown);
    showMore(shown);
  });
}

/// Editors of all boxes begin at the same place.
void SettingsPage::alignLabels() {
  int width = 0;
  for (const Box& box : boxes_)
    for (const SettingRow* row : box.rows) width = std::max(width, row->widestLabel());
  for (const Box& box : boxes_)
    for (SettingRow* row : box.rows) row->setLabelWidth(width);
}

void SettingsPage::showMore(bool shown) {
  more_->setChecked(shown);
  more_->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
  if (filters_) return;
  for (const Box& box : boxes_) box.widget->setVisible(isOpen(box));
}

bool SettingsPage::isOpen(const Box& box) const {
  return !more_ || more_->isChecked() || box.level == Level::basic;
}

void SettingsPage::setTop(QWidget* top) {
  top_ = top;
  layout_->insertWidget(0, top);
  setMinimumWidth(widget()->minimumSizeHint().width() + kScrollBar);
}

void SettingsPage::setUsable(bool usable) {
  for (const Box& box : boxes_) box.widget->setEnabled(usable);
}

void SettingsPage::update() {
  for (const Box& box : boxes_)
    for (SettingRow* row : box.rows) row->update();
}

int SettingsPage::filter(const QString& search, bool changedOnly) {
  int left = 0;
  filters_ = !search.isEmpty() || changedOnly;
  if (top_) top_->setVisible(!filters_);
  if (more_) more_->setVisible(!filters_);
  for (const Box& box : boxes_) {
    int inBox = 0;
    for (SettingRow* row : box.rows) {
      const bool fits = matches(row->row(), search.toStdString()) && (!changedOnly || row->isChanged());
      row->setVisible(fits);
      inBox += fits;
    }
    box.widget->setVisible(inBox > 0 && (filters_ || isOpen(box)));
    left += inBox;
  }
  return left;
}

}  // namespace gluray::panel
