#include "editors/choice_editor.h"

#include "qt_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace gluray::panel {

ChoiceEditor::ChoiceEditor(const Row& row, QWidget* parent) : Editor(parent), box_(new QComboBox(this)) {
  for (const Word& word : row.words) {
    box_->addItem(qtText(word.word));
    box_->setItemData(box_->count() - 1, qtText(word.help), Qt::ToolTipRole);
  }
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(box_, 1);
  setFocusProxy(box_);
  box_->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the page
  connect(box_, &QComboBox::activated, this,
          [this](int index) { emit changed(box_->itemText(index).toStdString(), false); });
}

void ChoiceEditor::show(const nlohmann::json& value) {
  const QSignalBlocker quiet(box_);
  box_->setCurrentIndex(value.is_string() ? box_->findText(QString::fromStdString(value.get<std::string>()))
                                          : -1);
}

}  // namespace gluray::panel
