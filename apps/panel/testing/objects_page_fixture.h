// For tests: the page of objects, and a program that answers.
#pragma once
#include "pages/objects/objects_page.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTableView>
#include <string>
#include <vector>

namespace gluray::panel {

struct ObjectsPageTest : testing::Test {
  void SetUp() override {
    program.values["objects"] = fakeObjects(4);
    QObject::connect(&program.controls, &Controls::settingsChanged, &page, [this] { page.update(); });
  }
  void showThem() {
    program.appear();
    page.show();
    ASSERT_TRUE(program.until([&] { return rows() > 0; }));
  }
  int rows() { return table().model()->rowCount(); }
  QTableView& table() { return *page.findChild<QTableView*>(); }
  QString message() { return page.findChild<QLabel*>("objects-message")->text(); }
  QString title() { return page.findChild<QLabel*>("objects-title")->text(); }
  QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
  std::vector<std::string> selected() {
    std::vector<std::string> numbers;
    for (const QModelIndex& index : table().selectionModel()->selectedRows())
      numbers.push_back(index.data().toString().toStdString());
    return numbers;
  }
  template <class Widget>
  Widget& part(const char* editor) {
    return *page.findChild<QWidget*>(editor)->findChild<Widget*>();
  }
  /// The next poll, without waiting for its second.
  void poll() {
    const size_t before = program.calls("objects").size();
    page.hide(), page.show();
    ASSERT_TRUE(program.until([&] { return program.calls("objects").size() > before; }));
    program.settle();
  }

  FakeProgram program;
  ObjectsPage page{program.controls, nullptr};
};

}  // namespace gluray::panel
