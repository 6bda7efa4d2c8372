// A text, a list, or the name of a file, which may be dropped here. GUI thread.
#pragma once
#include "editors/editor.h"

class QLineEdit;

namespace gluray::panel {

class TextEditor : public Editor {
 public:
  TextEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;
  bool busy() const override;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void send(const QString& text);
  void browse();

  const Row& row_;
  QLineEdit* line_;
  QString shown_;
};

}  // namespace gluray::panel
