#include "pages/settings_page.h"

#include <QVBoxLayout>

namespace gluray::panel {

SettingsPage::SettingsPage(const Page& page, Controls& controls, QWidget* parent)
    : QScrollArea(parent), controls_(controls) {
  auto* inside = new QWidget(this);
  layout_ = new QVBoxLayout(inside);
  for (const Section& section : page.sections) addSection(section);
  layout_->addStretch(1);
  setWidget(inside);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(inside->minimumSizeHint().width() + 24);
}

/// Neighbours of one setting each, whose name the heading would only repeat, share a box without one.
void SettingsPage::addSection(const Section& section) {
  const bool alone = section.rows.size() == 1 && section.rows[0]->name == section.word;
  if (!alone || boxes_.empty() || !boxes_.back().first->title().isEmpty()) {
    auto* made = new QGroupBox(alone ? QString() : QString::fromStdString(section.word), widget());
    new QVBoxLayout(made);
    layout_->addWidget(made);
    boxes_.emplace_back(made, std::vector<SettingRow*>());
  }
  auto& [box, rows] = boxes_.back();
  for (const Row* row : section.rows) {
    rows.push_back(new SettingRow(*row, controls_, box));
    if (!alone && row->name == section.word) rows.back()->headsGroup();
    box->layout()->addWidget(rows.back());
  }
}

void SettingsPage::setTop(QWidget* top) {
  top_ = top;
  layout_->insertWidget(0, top);
  setMinimumWidth(widget()->minimumSizeHint().width() + 24);
}

void SettingsPage::setUsable(bool usable) {
  for (const auto& [box, rows] : boxes_) box->setEnabled(usable);
}

void SettingsPage::update() {
  for (const auto& [box, rows] : boxes_)
    for (SettingRow* row : rows) row->update();
}

int SettingsPage::filter(const QString& search, bool changedOnly) {
  int left = 0;
  if (top_) top_->setVisible(search.isEmpty() && !changedOnly);
  for (const auto& [box, rows] : boxes_) {
    int inBox = 0;
    for (SettingRow* row : rows) {
      const bool fits = matches(row->row(), search.toStdString()) && (!changedOnly || row->isChanged());
      row->setVisible(fits);
      inBox += fits;
    }
    box->setVisible(inBox > 0);
    left += inBox;
  }
  return left;
}

}  // namespace gluray::panel
