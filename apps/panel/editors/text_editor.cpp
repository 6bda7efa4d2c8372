#include "editors/text_editor.h"

#include "control/messages/value.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>

namespace gluray::panel {

TextEditor::TextEditor(const Row& row, QWidget* parent)
    : Editor(parent), row_(row), line_(new QLineEdit(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(line_, 1);
  setFocusProxy(line_);
  connect(line_, &QLineEdit::editingFinished, this, [this] {
    if (line_->text() != shown_) send(line_->text());
  });
  if (row.type != Type::path) return;
  auto* button = new QPushButton(tr("Choose..."), this);
  layout->addWidget(button);
  connect(button, &QPushButton::clicked, this, [this] { browse(); });
  line_->setAcceptDrops(false);  // this widget takes files
  setAcceptDrops(true);
}

void TextEditor::show(const nlohmann::json& value) {
  shown_ = QString::fromStdString(control::textOf(row_, value).text);
  line_->setText(shown_);
}

bool TextEditor::busy() const { return line_->hasFocus() && line_->text() != shown_; }

void TextEditor::send(const QString& text) {
  shown_ = text;
  line_->setText(text);
  emit changed(text.toStdString(), false);
}

void TextEditor::browse() {
  auto* dialog = new QFileDialog(this, objectName(), line_->text());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { send(file); });
  dialog->open();
}

void TextEditor::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void TextEditor::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) return send(url.toLocalFile());
}

}  // namespace gluray::panel
