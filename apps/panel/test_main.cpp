// Tests of the panel: widgets without a screen.
#include "testing/reveal.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <cstdlib>

int main(int argc, char** argv) {
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  testing::InitGoogleTest(&argc, argv);
  QApplication application(argc, argv);
  const gluray::panel::OwnMemory memory;
  return RUN_ALL_TESTS();
}
