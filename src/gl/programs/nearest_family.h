// The family that a shader program most likely was meant for although it does not fit, for the user.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gluray::gl {

/// Families compete: first one that fits except for unknown statements, then the one that mentions most of
/// the program's variables, then the one with the fewest obstacles. A family that mentions none is not named.
class NearestFamily {
 public:
  /// A family that does not fit because of `obstacles`. `codeAlone`: they are unknown statements. Ignores
  /// families that are never traced or have another kind of vertices. Keeps a reference to the family.
  void take(const Program& program, const Family& family, bool codeAlone, std::vector<std::string> obstacles);
  bool fitsButForCode() const { return family_ && codeAlone_; }
  /// "; nearest: ..." with its first obstacles, or nothing.
  std::string text() const;

 private:
  bool isBeatenBy(bool codeAlone, size_t shared, size_t obstacles) const;

  const Family* family_ = nullptr;
  bool codeAlone_ = false;
  size_t shared_ = 0;  // variables of the program that the family mentions
  std::vector<std::string> obstacles_;
};

}  // namespace gluray::gl
