// For tests: settings by their names.
#pragma once
#include "settings/rows.h"

#include <gtest/gtest.h>

namespace gluray {

/// The setting's row; a failure, and any row, where there is none.
inline const Row& namedRow(const char* name) {
  const Row* found = findSetting(name);
  if (!found) ADD_FAILURE() << name;
  return found ? *found : settingRows()[0];
}

}  // namespace gluray
