#include "editors/boolean_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace gluray::panel {

BooleanEditor::BooleanEditor(const Row&, QWidget* parent)
    : Editor(parent), box_(new QCheckBox(tr("on"), this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(box_);
  setFocusProxy(box_);
  connect(box_, &QCheckBox::toggled, this, [this](bool on) { emit changed(on, false); });
}

void BooleanEditor::show(const nlohmann::json& value) {
  const QSignalBlocker quiet(box_);
  box_->setChecked(value.is_boolean() && value.get<bool>());
}

}  // namespace gluray::panel
