#include "pages/settings_page.h"

#include <QVBoxLayout>

namespace gluray::panel {

SettingsPage::SettingsPage(const Page& page, Controls& controls, QWidget* parent) : QScrollArea(parent) {
  auto* inside = new QWidget(this);
  auto* layout = new QVBoxLayout(inside);
  for (const Section& section : page.sections) {
    auto* box = new QGroupBox(QString::fromStdString(section.word), inside);
    auto* rows = new QVBoxLayout(box);
    boxes_.emplace_back(box, std::vector<SettingRow*>());
    for (const Row* row : section.rows) {
      boxes_.back().second.push_back(new SettingRow(*row, controls, box));
      rows->addWidget(boxes_.back().second.back());
    }
    layout->addWidget(box);
  }
  layout->addStretch(1);
  setWidget(inside);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(inside->minimumSizeHint().width() + 24);
}

void SettingsPage::update() {
  for (const auto& [box, rows] : boxes_)
    for (SettingRow* row : rows) row->update();
}

int SettingsPage::filter(const QString& search, bool changedOnly) {
  int left = 0;
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
