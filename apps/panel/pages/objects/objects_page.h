// The objects that the chosen program draws: a table, and below it what the selected ones are made of. GUI
// thread.
#pragma once
#include "model/object_list.h"
#include "pages/objects/object_table.h"

#include <QWidget>
#include <optional>
#include <set>

class QLabel;
class QTableView;

namespace gluray::panel {

class ObjectEditor;

class ObjectsPage : public QWidget {
  Q_OBJECT

 public:
  ObjectsPage(Controls& controls, QWidget* parent);
  /// Selects one object, also one that the program has not told of yet; 0: none.
  void select(uint32_t number);
  /// Shows the objects in which each word is found. Returns how many are left.
  int filter(const QString& search);
  /// Shows what the chosen program's settings say.
  void update();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void makeTable();
  QWidget* makeNote();
  void takeList();
  void mark();
  void takeSelection();
  void edit();
  QString messageNow() const;

  Controls& controls_;
  ObjectList list_;
  ObjectTable rows_;
  ObjectFilter filter_;
  QLabel* message_;
  QTableView* table_;
  QWidget* note_;
  ObjectEditor* editor_;
  std::set<uint32_t> selected_;
  std::optional<uint32_t> wanted_;  // to be selected when it comes
  bool marking_ = false;
};

}  // namespace gluray::panel
