#include "editors/boolean_editor.h"
#include "editors/choice_editor.h"
#include "editors/color_editor.h"
#include "editors/number_editor.h"
#include "editors/text_editor.h"
#include "editors/vector_editor.h"
#include "qt_text.h"

namespace gluray::panel {
namespace {

Editor* newEditor(const Row& row, QWidget* parent) {
  switch (row.type) {
    case Type::boolean: return new BooleanEditor(row, parent);
    case Type::integer:
    case Type::real: return new NumberEditor(row, parent);
    case Type::choice: return new ChoiceEditor(row, parent);
    case Type::color: return new ColorEditor(row, parent);
    case Type::vector: return new VectorEditor(row, parent);
    default: return new TextEditor(row, parent);
  }
}

}  // namespace

Editor* makeEditor(const Row& row, QWidget* parent) {
  Editor* editor = newEditor(row, parent);
  editor->setObjectName(qtText(row.name));
  if (QWidget* proxy = editor->focusProxy()) {
    proxy->setAccessibleName(qtText(row.title));
    proxy->setAccessibleDescription(qtText(row.help));
  }
  return editor;
}

}  // namespace gluray::panel
