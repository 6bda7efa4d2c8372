// The page of objects: what it changes of those that are selected.
#include "testing/objects_page_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QPushButton>
#include <QSlider>

namespace gluray::panel {
namespace {

using nlohmann::json;

TEST_F(ObjectsPageTest, ChoosesTheMaterialOfTheSelectedObjects) {
  showThem();
  table().selectAll();
  EXPECT_EQ(title(), "4 objects: 1, 2, 3, 4");
  page.select(2);
  auto& material = part<QComboBox>("object.material");
  EXPECT_EQ(material.currentText(), "program");
  material.setCurrentText("glass");
  emit material.activated(material.currentIndex());
  ASSERT_EQ(program.sets().size(), 1u);
  EXPECT_EQ(program.sets()[0]["values"], json({{"material.objects", {"2 glass"}}}));
  auto& ior = part<QDoubleSpinBox>("object.material.ior");
  ior.setValue(1.75);
  EXPECT_EQ(program.sets().back()["values"], json({{"material.objects", {"2 glass ior=1.75"}}}))
      << "the program has not yet said that it took the first";
  EXPECT_NE(program.sets()[0]["gesture"], program.sets()[1]["gesture"]) << "two steps of undo";
  program.settle();
  EXPECT_EQ(material.currentText(), "glass");
  page.select(1);
  EXPECT_EQ(material.currentText(), "program");
}

TEST_F(ObjectsPageTest, ADragIsOneGestureForAllSelectedObjects) {
  showThem();
  program.say("material.objects", {"3 glass"});
  table().selectAll();
  auto& slider = part<QSlider>("object.material.roughness");
  slider.setSliderDown(true);
  for (int i = 1; i < 30; ++i) slider.setValue(i * 20);
  slider.setSliderDown(false);
  const auto sets = program.sets();
  ASSERT_GE(sets.size(), 2u);
  EXPECT_LT(sets.size(), 20u);
  for (const json& set : sets) EXPECT_EQ(set["gesture"], sets[0]["gesture"]);
  const json entries = sets.back()["values"]["material.objects"];
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_EQ(entries[0].get<std::string>().substr(0, 18), "3 glass roughness=");
}

TEST_F(ObjectsPageTest, HidesObjectsFromRays) {
  showThem();
  program.say("material.objects", {"1 hidden-from=shadow", "2 mirror"});
  page.select(1);
  auto* camera = page.findChild<QCheckBox*>("hidden-from.camera");
  auto* shadow = page.findChild<QCheckBox*>("hidden-from.shadow");
  EXPECT_TRUE(shadow->isChecked());
  table().selectAll();
  EXPECT_EQ(shadow->checkState(), Qt::PartiallyChecked);
  page.select(1);
  camera->click();
  EXPECT_EQ(program.sets().back()["values"],
            json({{"material.objects", {"1 hidden-from=camera+shadow", "2 mirror"}}}));
  camera->click(), shadow->click();
  EXPECT_EQ(program.sets().back()["values"]["material.objects"][0], "1 hidden-from=none");
}

TEST_F(ObjectsPageTest, TakesEntriesBack) {
  showThem();
  auto* remove = page.findChild<QPushButton*>("objects-remove");
  page.select(2);
  EXPECT_FALSE(remove->isEnabled());
  program.say("material.objects", {"1 glass", "2 mirror ior=2"});
  EXPECT_TRUE(remove->isEnabled());
  remove->click();
  EXPECT_EQ(program.sets().back()["values"], json({{"material.objects", {"1 glass"}}}));
  EXPECT_FALSE(remove->isEnabled());
}

TEST_F(ObjectsPageTest, ManyObjectsAreChangedAtOnce) {
  program.values["objects"] = fakeObjects(1000);
  showThem();
  table().selectAll();
  auto& material = part<QComboBox>("object.material");
  material.setCurrentText("glass");
  QElapsedTimer time;
  time.start();
  emit material.activated(material.currentIndex());
  program.settle();
  part<QDoubleSpinBox>("object.material.ior").setValue(1.75);
  EXPECT_LT(time.elapsed(), 2000);
  EXPECT_EQ(program.sets().back()["values"]["material.objects"].size(), 1000u);
  EXPECT_EQ(program.sets().back()["values"]["material.objects"][999], "1000 glass ior=1.75");
}

TEST_F(ObjectsPageTest, WhatAProgramRefusesIsNotShown) {
  showThem();
  page.select(2);
  program.answers = false;
  auto& material = part<QComboBox>("object.material");
  material.setCurrentText("glass");
  emit material.activated(material.currentIndex());
  program.receiveMessage(
      {{"type", "answer"}, {"id", program.sent.back()["id"]}, {"why", "the list is too long"}});
  EXPECT_EQ(material.currentText(), "program");
}

TEST_F(ObjectsPageTest, SaysWhereMaterialsAreSeen) {
  showThem();
  auto* note = page.findChild<QWidget*>("objects-note");
  EXPECT_TRUE(note->isVisible());
  note->findChild<QPushButton*>()->click();
  EXPECT_EQ(program.sets().back()["values"], json({{"integrator", "path"}}));
  ASSERT_TRUE(program.until([&] { return !note->isVisible(); }));
}

}  // namespace
}  // namespace gluray::panel
