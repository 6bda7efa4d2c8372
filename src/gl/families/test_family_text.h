// What tests of family files share.
#pragma once
#include "gl/families/family.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {

/// Four lines, complete.
inline const std::string kLeast =
    "[[family]]\nname = \"f\"\nmatch.active = [\"p\", \"m\"]\nvertex.position = \"p\"\n"
    "transform.clip_from_object = \"m\"\n";

/// What parseFamilies() finds wrong with the file x.toml.
inline std::string mistake(const std::string& text) {
  try {
    parseFamilies(text, "x.toml");
  } catch (const FamilyError& e) { return e.what(); }
  return "none";
}

/// The one family of that file with `more` lines.
inline Family parsed(const std::string& more = "") {
  const FamilyList list = parseFamilies(kLeast + more, "x.toml");
  EXPECT_EQ(list.size(), 1u);
  return *list.at(0);
}

}  // namespace gluray::gl
