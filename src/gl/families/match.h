// Which family a program belongs to. GL thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/programs/program.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

/// A program with the family that describes it.
struct KnownProgram {
  Program program;
  std::shared_ptr<const Family> family;  // null: none fits
  std::string why;           // of programs that are not traced, for the user: "family X: lacks uniform y"
  std::string note;          // of programs that are traced: what a family had to decide
  bool unknownCode = false;  // a family fits but for statements that it does not know
};

/// For each name of the family that the program lacks, the first of its alternatives that the program has;
/// for Family::anyTexture the program's only other texture.
Renames renamedBy(const Program& program, const Family& family);

/// What keeps `program` from being one of `family`, which knows sections of `code`; empty where nothing does.
std::vector<std::string> obstacles(const RealGl& real, Program program, const Family& family,
                                   const CodeSections& code = {});

/// Reads the program and finds its family.
std::shared_ptr<const KnownProgram> recognise(const RealGl& real, GLuint name, const FamilyList& families);

}  // namespace gluray::gl
