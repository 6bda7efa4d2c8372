#include "editors/color_editor.h"

#include "qt_text.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QPixmap>
#include <QPushButton>
#include <algorithm>
#include <memory>

namespace gluray::panel {
namespace {

/// Of "#rrggbb" or of three numbers from 0 to 1.
QColor colorOf(const nlohmann::json& value) {
  if (value.is_string()) return QColor(QString::fromStdString(value.get<std::string>()));
  if (!value.is_array() || value.size() != 3) return {};
  const auto channel = [&](size_t i) {
    return value[i].is_number() ? std::clamp(value[i].get<double>(), 0.0, 1.0) : 0;
  };
  return QColor::fromRgbF(static_cast<float>(channel(0)), static_cast<float>(channel(1)),
                          static_cast<float>(channel(2)));
}

}  // namespace

ColorEditor::ColorEditor(const Row&, QWidget* parent) : Editor(parent), button_(new QPushButton(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(button_, 1);
  setFocusProxy(button_);
  connect(button_, &QPushButton::clicked, this, [this] { ask(); });
}

void ColorEditor::show(const nlohmann::json& value) {
  color_ = colorOf(value);
  QPixmap sample(button_->iconSize());
  sample.fill(color_);
  button_->setIcon(sample);
  button_->setText(color_.name());
}

void ColorEditor::ask() {
  auto* dialog = new QColorDialog(color_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(objectName());
  // The image follows.
  const auto sent = std::make_shared<bool>(false);
  connect(dialog, &QColorDialog::currentColorChanged, this, [this, sent](const QColor& color) {
    *sent = true;
    emit changed(color.name().toStdString(), true);
  });
  connect(dialog, &QColorDialog::finished, this, [this, dialog, sent](int result) {
    if (!*sent) return;
    result == QDialog::Accepted ? emit changed(dialog->currentColor().name().toStdString(), false)
                                : emit
                                  cancelled();
  });
  dialog->open();
}

}  // namespace gluray::panel
