// Helpers for tests of family files.
#pragma once
#include "gl/families/family.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {

/// The smallest complete family.
inline const std::string kMin =
    "[[family]]\nname = \"f\"\nmatch.active = [\"p\", \"m\"]\nvertex.position = \"p\"\n"
    "transform.clip_from_object = \"m\"\n";

/// The error of parseFamilies() for a file x.toml with this text; "none" if there is none.
inline std::string mistake(const std::string& text) {
  try {
    parseFamilies(text, "x.toml");
  } catch (const FamilyError& e) { return e.what(); }
  return "none";
}

/// The error for kMin with one more line.
inline std::string mistakeIn(const std::string& line) { return mistake(kMin + line + "\n"); }

/// The family kMin with `more` lines appended.
inline Family parsed(const std::string& more = "") {
  const FamilyList list = parseFamilies(kMin + more, "x.toml");
  EXPECT_EQ(list.size(), 1u);
  return *list.at(0);
}

}  // namespace gluray::gl
