// The known code of VTK's volumes: shaders composed of its fragments are known, those of mixed ones are not.
#include "gl/families/family.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

using Words = std::map<std::string, std::string>;  // by group

const std::vector<std::string> kVolumeCode = {"VTK volume"};

class VolumeFamilies : public testing::Test {
 protected:
  VolumeFamilies() { slots_.add(code().fragments()); }
  static const KnownCode& code() { return builtInFamilies().code.at("VTK volume"); }

  /// The text of a pattern, with the fragments that `fragmentOf` chooses for its slots.
  using FragmentOf = std::function<std::string(const std::string& group, const std::string& part)>;
  static std::string composed(const PatternText& pattern, const FragmentOf& fragmentOf) {
    std::string text;
    for (const PatternText::Piece& piece : pattern.pieces()) {
      if (piece.kind == PatternText::Piece::Kind::slot)
        text += " " + composed(PatternText(fragmentOf(piece.text, piece.part)), fragmentOf) + " ";
      else if (piece.kind == PatternText::Piece::Kind::number)
        text += " 1";
      else
        text += piece.text;
    }
    return text;
  }

  /// The first fragment of a word; empty if it has none.
  static std::string first(const std::string& group, const std::string& word, const std::string& part) {
    for (const SlotWord& entry : code().fragments().groups().at(group)) {
      const auto texts = entry.parts.find(part);
      if (entry.word == word && texts != entry.parts.end()) return texts->second.front().text();
    }
    return "";
  }

  /// A slot that has the fragment of another word.
  struct Other {
    std::string group, part, word;
  };
  /// The functions of a shader that has these words.
  static GlslStatements shader(const Words& words, const Other& other = {}) {
    std::string text;
    for (const StatementPattern& pattern : code().patterns()) {
      if (pattern.text().text().find('(') == std::string::npos) continue;  // declarations
      text += composed(pattern.text(), [&](const std::string& group, const std::string& part) {
        const bool replaced = group == other.group && part == other.part;
        return first(group, replaced ? other.word : words.at(group), part);
      });
    }
    GlslStatements statements;
    statements.cut(text);
    return statements;
  }

  static Words words(const std::string& blend, const std::string& light, const std::string& gradient) {
    return {{"blend", blend},
            {"light", light},
            {"gradient", gradient},
            {"eye", "data"},
            {"kept", "step"},
            {"jitter", ""},
            {"index", "variable"},
            {"channels", "one"},
            {"slice", "no"},
            {"crop", ""},
            {"mask", ""},
            {"clip", "crop"},
            {"clipstart", "any"},
            {"clipend", "any"},
            {"lamps", "loop"},
            {"differences", "central"},
            {"magnitude", "length"},
            {"headlight", "directions"},
            {"zero", "zero"}};
  }

  static std::vector<std::string> unknown(const GlslStatements& statements) {
    const auto found = unknownStatements(statements, builtInFamilies().code, kVolumeCode);
    return {found.begin(), found.end()};
  }

  /// What readWords() returns for the shader.
  std::string wordless(const GlslStatements& statements) {
    words_.clear();
    return readWords(statements, builtInFamilies().code, kVolumeCode, words_);
  }

  Slots slots_;
  SlotWords words_;
};

TEST_F(VolumeFamilies, ComposedShadersAreKnown) {
  std::vector<Words> all{words("", "", "")};
  for (const char* const group : {"blend", "light", "gradient", "channels", "eye", "kept", "jitter"}) {
    std::vector<std::string> choices = slots_.words(group);
    ASSERT_FALSE(choices.empty()) << group;
    if (std::string(group) == "kept" || std::string(group) == "jitter") choices.emplace_back();
    std::vector<Words> more;
    for (const std::string& word : choices)
      for (Words words : all) words[group] = word, more.push_back(words);
    all = more;
  }
  EXPECT_GE(all.size(), 7u * 5 * 3 * 4 * 2 * 2 * 2);
  // Other groups change from one combination to the next.
  const std::pair<const char*, std::vector<std::string>> others[] = {
      {"index", {"component", "variable"}}, {"slice", {"no", "plane", "no"}}, {"crop", {"", "regions", ""}},
      {"mask", {"", "", "binary", ""}},     {"clip", {"texture", "crop"}},    {"lamps", {"", "loop"}}};
  for (size_t i = 0; i < all.size(); ++i) {
    Words& words = all[i];
    for (const auto& [group, choices] : others) words[group] = choices[i % choices.size()];
    if (words.at("light") != "none" && words.at("gradient") == "none") continue;  // no gradient to light with
    const GlslStatements statements = shader(words);
    ASSERT_EQ(unknown(statements), std::vector<std::string>{});
    ASSERT_EQ(wordless(statements), "");
    for (const char* const group :
         {"blend", "light", "gradient", "channels", "slice", "crop", "mask", "clip", "eye", "kept", "jitter"})
      ASSERT_EQ(words_.at("@" + std::string(group)), words.at(group)) << group;
  }
}

TEST_F(VolumeFamilies, MixedShadersAreNot) {
  const Words lit = words("maximum", "viewer", "magnitude");
  EXPECT_EQ(wordless(shader(lit)), "");
  for (const char* const part : {"start", "sample", "end"}) {
    for (const std::string& word : slots_.words("blend"))
      EXPECT_EQ(wordless(shader(lit, {"blend", part, word})), word == "maximum" ? "" : "@blend")
          << part << word;
  }
  for (const char* const part : {"start", "gradient", "color"})
    EXPECT_EQ(wordless(shader(lit, {"light", part, "none"})), "@light") << part;
  for (const char* const part : {"body", "value"})
    EXPECT_EQ(wordless(shader(lit, {"gradient", part, "direction"})), "@gradient") << part;
  EXPECT_EQ(wordless(shader(lit, {"gradient", "opacity", "direction"})), "");
  EXPECT_EQ(words_.at("@gradient"), "table") << "nothing is weighed by lengths";
  for (const char* const part : {"start", "position", "viewer", "light"})
    EXPECT_EQ(wordless(shader(lit, {"eye", part, "world"})), "@eye") << part;
  for (const char* const part : {"value", "factor"})
    EXPECT_EQ(wordless(shader(lit, {"jitter", part, "noise"})), "@jitter") << part;
  for (const char* const part : {"length", "jitter"})
    EXPECT_EQ(wordless(shader(lit, {"kept", part, ""})), "@kept") << part;
  EXPECT_EQ(wordless(shader(words("maximum", "none", "none"), {"light", "start", "viewer"})), "");
  EXPECT_EQ(words_.at("@light"), "none") << "a light that is not used";
  Words black = words("composite", "", "none");
  EXPECT_EQ(wordless(shader(black)), "@light") << "neither lit nor the colour of the table";
}

TEST_F(VolumeFamilies, DeclarationsBelongToTheBlend) {
  const auto declared = [&](const std::string& declaration) {
    GlslStatements statements = shader(words("maximum", "none", "none"));
    statements.cut(declaration);
    EXPECT_EQ(unknown(statements), std::vector<std::string>{}) << declaration;
    return wordless(statements);
  };
  EXPECT_EQ(declared("vec4 l_maxValue; bool l_firstValue;"), "");
  EXPECT_EQ(declared("vec4 l_minValue;"), "@blend");
  EXPECT_EQ(declared("vec4 g_eyePosObjs[1];"), "@eye");
}

}  // namespace
}  // namespace gluray::gl
