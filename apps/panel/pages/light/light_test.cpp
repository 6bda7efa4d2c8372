#include "pages/light/light_direction.h"
#include "pages/light/light_list.h"
#include "pages/light/light_sphere.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QLabel>
#include <QTest>
#include <QTreeWidget>
#include <cmath>

namespace gluray::panel {
namespace {

using nlohmann::json;

TEST(LightDirectionTest, TheHighlightIsHalfWayToTheViewer) {
  EXPECT_NEAR(std::hypot(highlightAt({0, 0}).x(), highlightAt({0, 0}).y()), 0, 1e-9);
  EXPECT_NEAR(highlightAt({90, 0}).x(), std::sqrt(0.5), 1e-9) << "from the right";
  EXPECT_NEAR(highlightAt({0, 90}).y(), std::sqrt(0.5), 1e-9) << "from above";
  EXPECT_GT(highlightAt({170, 0}).x(), 0.99) << "from behind: at the rim";
  for (double azimuth = -170; azimuth < 180; azimuth += 10)
    for (double elevation = -80; elevation < 90; elevation += 10) {
      const LightDirection again = directionFor(highlightAt({azimuth, elevation}));
      EXPECT_NEAR(again.azimuth, azimuth, 1e-6);
      EXPECT_NEAR(again.elevation, elevation, 1e-6);
    }
}

TEST(LightDirectionTest, PlacesBesideTheBallAreItsRim) {
  const LightDirection beside = directionFor({5, 0});
  EXPECT_NEAR(beside.azimuth, directionFor({0.999, 0}).azimuth, 1e-6);
  EXPECT_TRUE(std::isfinite(directionFor({0, 0}).azimuth));
  EXPECT_TRUE(std::isfinite(highlightAt({180, 0}).x()));
}

struct LightSphereTest : testing::Test {
  void SetUp() override {
    program.appear();
    sphere.resize(106, 106);
    sphere.show();
    QObject::connect(&program.controls, &Controls::settingsChanged, &sphere, [this] { sphere.update(); });
    QObject::connect(&sphere, &LightSphere::said, &sphere, [this](const QString& line) { said << line; });
  }
  FakeProgram program;
  LightSphere sphere{program.controls, nullptr};
  QStringList said;
};

TEST_F(LightSphereTest, ADragIsOneGestureAndChoosesARig) {
  program.say("lights", "program");
  QTest::mousePress(&sphere, Qt::LeftButton, {}, {53, 53});
  for (int i = 0; i < 20; ++i) QTest::mouseMove(&sphere, {53 + i, 53});
  QTest::mouseRelease(&sphere, Qt::LeftButton, {}, {78, 53});
  const auto sets = program.sets();
  ASSERT_GE(sets.size(), 2u);
  for (const json& set : sets) {
    EXPECT_EQ(set["gesture"], sets[0]["gesture"]);
    EXPECT_EQ(set["values"]["lights"], "headlight+key");
  }
  EXPECT_NEAR(sets.back()["values"]["lights.azimuth"].get<double>(), 60, 3)
      << "half of the radius is 30 degrees";
  EXPECT_NEAR(sets.back()["values"]["lights.elevation"].get<double>(), 0, 0.1);
  EXPECT_FALSE(said.isEmpty());
  QTest::mouseClick(&sphere, Qt::LeftButton, {}, {53, 80});
  EXPECT_LT(program.sets().back()["values"]["lights.elevation"], -50) << "below the middle";
}

TEST_F(LightSphereTest, ArrowKeysTurnByFiveDegrees) {
  program.say("lights", "sun");
  program.say("lights.azimuth", 178);
  program.say("lights.elevation", 88);
  QTest::keyClick(&sphere, Qt::Key_Right);
  EXPECT_EQ(program.sets().back()["values"], json({{"lights.azimuth", -177.0}, {"lights.elevation", 88.0}}));
  QTest::keyClick(&sphere, Qt::Key_Up);
  EXPECT_EQ(program.sets().back()["values"]["lights.elevation"], 90.0);
  EXPECT_EQ(program.sets()[0]["gesture"], program.sets()[1]["gesture"]);
  const QAccessibleInterface* access = QAccessible::queryAccessibleInterface(&sphere);
  ASSERT_NE(access, nullptr);
  EXPECT_EQ(access->text(QAccessible::Name), "Direction of the key light");
  EXPECT_EQ(access->text(QAccessible::Value), "azimuth -177 degrees, elevation 90 degrees");
}

TEST_F(LightSphereTest, ShowsValuesOfAnyKind) {
  program.say("lights.azimuth", "x");
  program.say("lights.elevation", json::array());
  EXPECT_EQ(sphere.valueText(), "azimuth 0 degrees, elevation 0 degrees");
  program.end();
  EXPECT_FALSE(sphere.isEnabled());
}

TEST(LightListTest, ShowsTheLightsWhileItIsSeen) {
  FakeProgram program;
  program.values["lights"] = {{"lights",
                               {{{"name", "key"},
                                 {"from", "rig"},
                                 {"kind", "directional"},
                                 {"azimuth", 30},
                                 {"elevation", 45.25},
                                 {"color", "#ffffff"},
                                 {"strength", 1}},
                                {{"name", 3}, {"azimuth", nullptr}, {"color", "?"}},
                                "x"}}};
  LightList list(program.controls, nullptr);
  program.appear();
  program.settle();
  EXPECT_TRUE(program.calls("lights").empty());
  list.show();
  auto* tree = list.findChild<QTreeWidget*>();
  ASSERT_TRUE(program.until([&] { return tree->topLevelItemCount() == 2; }));
  EXPECT_EQ(tree->topLevelItem(0)->text(0), "key");
  EXPECT_EQ(tree->topLevelItem(0)->text(4), "30");
  tree->setCurrentItem(tree->topLevelItem(0));
  program.refusals["lights"] = "it draws nothing";
  auto* label = list.findChild<QLabel*>();
  ASSERT_TRUE(program.until([&] { return label->text() == "No list of lights: it draws nothing"; }));
  for (const json& value : {json(), json(3), json{{"lights", 4}}, json{{"lights", json::array()}}}) {
    program.refusals.clear();
    program.values["lights"] = value;
    list.hide(), list.show();
    program.settle();
  }
  EXPECT_EQ(label->text(), "No light shines on the traced objects.");
}

}  // namespace
}  // namespace gluray::panel
