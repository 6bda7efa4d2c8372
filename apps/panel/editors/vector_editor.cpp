#include "editors/vector_editor.h"

#include "editors/number_box.h"
#include "qt_text.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

namespace gluray::panel {

VectorEditor::VectorEditor(const Row& row, QWidget* parent) : Editor(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (size_t i = 0; i < boxes_.size(); ++i) {
    boxes_[i] = new NumberBox(row, this);
    boxes_[i]->setMinimumWidth(60);
    boxes_[i]->setAccessibleName(qtText(row.name) + " " + "xyz"[i]);
    layout->addWidget(boxes_[i], 1);
    connect(boxes_[i], &QDoubleSpinBox::valueChanged, this, [this] {
      emit changed({boxes_[0]->value(), boxes_[1]->value(), boxes_[2]->value()}, false);
    });
  }
  setFocusProxy(boxes_[0]);
}

bool VectorEditor::busy() const {
  return std::any_of(boxes_.begin(), boxes_.end(), [](const NumberBox* box) { return box->typing(); });
}

void VectorEditor::show(const nlohmann::json& value) {
  for (size_t i = 0; i < boxes_.size(); ++i) {
    const QSignalBlocker quiet(boxes_[i]);
    boxes_[i]->setValue(value.is_array() && value.size() > i && value[i].is_number() ? value[i].get<double>()
                                                                                     : 0);
  }
}

}  // namespace gluray::panel
