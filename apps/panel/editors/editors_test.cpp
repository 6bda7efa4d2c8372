#include "control/messages/value.h"
#include "editors/editor.h"
#include "editors/number_editor.h"
#include "settings/named_row.h"
#include "settings/values.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSlider>
#include <QTest>

namespace gluray::panel {
namespace {

using nlohmann::json;

/// An editor and what it emits.
struct Made {
  explicit Made(const char* name) : editor(makeEditor(namedRow(name), nullptr)) {
    QObject::connect(editor.get(), &Editor::changed, editor.get(), [this](const json& value, bool more) {
      values.push_back(value), mores.push_back(more);
    });
  }
  template <class T>
  T* part() const {
    return editor->findChild<T*>();
  }
  std::unique_ptr<Editor> editor;
  std::vector<json> values;
  std::vector<bool> mores;
};

TEST(Scale, HasItsEndsAndRunsUpwards) {
  for (const auto& [least, most] :
       {std::pair(0.0, 1.0), {1.0, 4096.0}, {0.0, 1e6}, {-180.0, 180.0}, {0.001, 1e5}}) {
    const Scale scale(least, most, 1);
    EXPECT_EQ(scale.valueAt(0), least);
    EXPECT_EQ(scale.valueAt(Scale::kSteps), most);
    EXPECT_EQ(scale.positionOf(least), 0);
    EXPECT_EQ(scale.positionOf(most), Scale::kSteps);
    for (int i = 1; i <= Scale::kSteps; ++i) {
      ASSERT_GE(scale.valueAt(i), scale.valueAt(i - 1)) << least << " " << most << " " << i;
      ASSERT_NEAR(scale.positionOf(scale.valueAt(i)), i, 7) << least << " " << most;  // three digits
    }
  }
}

TEST(Editors, ShowTheBuiltInValueOfEverySettingAndEmitNothing) {
  for (const Row& one : settingRows()) {
    const std::string name(one.name);
    Made made(name.c_str());
    made.editor->show(control::valueOf(one, printValue(one, Session{})));
    EXPECT_TRUE(made.values.empty()) << name;
    EXPECT_NE(made.editor->focusProxy(), nullptr) << name;
    EXPECT_FALSE(made.editor->focusProxy()->accessibleName().isEmpty()) << name;
  }
}

TEST(Editors, SurviveValuesOfOtherTypes) {
  for (const Row& one : settingRows()) {
    const std::string name(one.name);
    Made made(name.c_str());
    for (const json& value : {json(), json("?"), json(1e300), json(true), json({1, "a"}), json::object()})
      made.editor->show(value);
    EXPECT_TRUE(made.values.empty()) << name;
  }
}

TEST(Editors, ASwitchSendsABoolean) {
  Made made("ao");
  made.part<QCheckBox>()->click();
  EXPECT_EQ(made.values, std::vector<json>{true});
}

TEST(Editors, AChoiceSendsItsWord) {
  Made made("bvh");
  made.editor->show("fast");
  auto* box = made.part<QComboBox>();
  EXPECT_EQ(box->currentText(), "fast");
  QTest::keyClick(box, Qt::Key_Down);
  ASSERT_EQ(made.values.size(), 1u);
  EXPECT_EQ(made.values[0], "full");
}

TEST(Editors, ANumberIsTypedOrSlid) {
  Made made("ao.samples");
  made.editor->show(16);
  auto* box = made.part<QDoubleSpinBox>();
  EXPECT_EQ(box->text(), "16 rays");
  box->selectAll();
  QTest::keyClicks(box, "32");
  EXPECT_TRUE(made.values.empty());  // not yet complete
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(made.values, std::vector<json>{32});
  EXPECT_TRUE(made.values[0].is_number_integer());
  auto* slider = made.part<QSlider>();
  ASSERT_NE(slider, nullptr);
  slider->setSliderDown(true);
  slider->setValue(Scale::kSteps);
  ASSERT_EQ(made.values.size(), 2u);
  EXPECT_TRUE(made.mores[1]);
  EXPECT_TRUE(made.editor->busy());
  slider->setSliderDown(false);
  ASSERT_EQ(made.values.size(), 3u);
  EXPECT_FALSE(made.mores[2]);
  EXPECT_EQ(made.values[2], made.values[1]);
}

TEST(Editors, NumbersKeepTheirDigits) {
  Made made("ground.offset");
  made.editor->show(1e-7);
  auto* box = made.part<QDoubleSpinBox>();
  EXPECT_TRUE(box->text().startsWith("1e-07")) << box->text().toStdString();
  EXPECT_DOUBLE_EQ(box->value(), 1e-7);
}

TEST(Editors, ATextIsSentWhenItIsComplete) {
  Made made("lights.file");
  auto* line = made.part<QLineEdit>();
  QTest::keyClicks(line, "/a.toml");
  EXPECT_TRUE(made.values.empty());
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(made.values, std::vector<json>{"/a.toml"});
}

}  // namespace
}  // namespace gluray::panel
