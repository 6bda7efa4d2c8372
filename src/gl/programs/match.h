// Finds the family that fits a shader program. GL thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/functions/shader_functions.h"
#include "gl/glsl/program.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

/// A shader program with its family.
struct KnownProgram {
  Program program;
  std::shared_ptr<const Family> family;  // null: none fits
  std::string why;                       // why it is not traced, for the user; empty if it is traced
  std::string note;                      // notes of its code sections, for the user, if it is traced
  int lightCount = -1;                   // by FamilyLights::countInSource; -1: not counted
  int highlightCount = -1;               // by FamilyLights::noHighlightInSource; -1: not counted
  float prefilteredMaxLevel = 0;         // by FamilyPbr::prefilteredMaxLevelInSource
  PlaceholderValues placeholders;        // numbers in its statements
  SlotWords words;                       // of the slots in its statements
  FunctionNames functionNames;           // of functions that are evaluated, by placeholders
  /// The shaders that have them.
  std::vector<std::shared_ptr<const glsl::ShaderFunctions>> functions;
  bool ignoresOpacity = false;     // by FamilyMaterial::unusedOpacityInSource
  bool discardsInvisible = false;  // by Family::discardsInvisibleInSource
  bool unknownCode = false;        // the nearest family fits except for unknown statements
  /// The same program with further families, for other values of uniforms (Family::decided).
  std::vector<std::shared_ptr<const KnownProgram>> others;
};

/// Reasons why `program` does not fit `family`, whose known sections are in `code`; empty if it fits.
std::vector<std::string> obstacles(const RealGl& real, Program program, const Family& family,
                                   const CodeSections& code = {});

/// Queries the shader program and finds its family, and the families for other values of its uniforms.
/// `texts`: Program::texts.
std::shared_ptr<const KnownProgram> recognise(const RealGl& real, GLuint name, const FamilyList& families,
                                              std::shared_ptr<const ShaderTexts> texts = {});

}  // namespace gluray::gl
