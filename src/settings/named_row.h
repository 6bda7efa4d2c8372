// Finds settings by name, for tests.
#pragma once
#include "settings/rows.h"

#include <gtest/gtest.h>

namespace gluray {

/// The setting's row. If there is none, the test fails, and another row is returned.
inline const Row& namedRow(const char* name) {
  const Row* found = findSetting(name);
  if (!found) ADD_FAILURE() << name;
  return found ? *found : settingRows()[0];
}

}  // namespace gluray
