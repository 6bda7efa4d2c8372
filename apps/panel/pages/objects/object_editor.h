// What the selected objects are made of, and which rays do not meet them: shows and changes their entries of
// the setting material.objects. GUI thread.
#pragma once
#include "model/movement.h"
#include "model/object_list.h"
#include "settings/rows.h"

#include <QElapsedTimer>
#include <QWidget>
#include <array>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace gluray::panel {

class Editor;

class ObjectEditor : public QWidget {
  Q_OBJECT

 public:
  ObjectEditor(Controls& controls, QWidget* parent);
  /// Chooses what is edited; none: nothing can be.
  void show(std::vector<DrawnObject> objects);
  /// Shows the values again.
  void update();

 private:
  struct Field {
    const Row* row = nullptr;
    QLabel* label = nullptr;
    Editor* editor = nullptr;
  };

  void makeFields(QGridLayout* grid);
  QWidget* makeRays();
  void changeRays();
  /// Says `words` of all objects; none: takes their entries out. Changes of one editor may be one movement.
  void change(const QObject* editor, const std::vector<std::string>& words, bool more);
  void send(const QObject* editor, std::vector<std::string> entries, bool more);
  void takeBack();
  /// Those that the program has, or was last sent.
  std::vector<std::string> entriesNow() const;
  /// The setting's value for objects_[at]; `said` becomes true if its entry has it.
  nlohmann::json valueOf(const Row& row, size_t at, const nlohmann::json& otherwise, bool& said) const;
  QStringList hiddenOf(size_t at, bool& said) const;
  void showField(const Field& field);
  void showRays();

  Controls& controls_;
  Movement movement_;
  const QObject* moved_ = nullptr;  // the editor whose movement it is
  std::vector<DrawnObject> objects_;
  std::vector<std::vector<std::string>> words_;  // of the objects' entries
  std::vector<Field> fields_;
  std::array<QCheckBox*, 4> rays_{};
  QLabel *title_ = nullptr, *hidden_ = nullptr;
  QPushButton* remove_ = nullptr;
  std::optional<std::vector<std::string>> sent_;  // what the program has not yet said again
  QElapsedTimer sentAt_;
  Value before_;  // when the movement began
};

}  // namespace gluray::panel
