// The families of spec/programs, which the engine embeds as text.
#include "gl/families/built_in_families.gen.h"
#include "gl/families/family.h"

namespace gluray::gl {

const FamilyList& builtInFamilies() {
  static const FamilyList families = [] {
    FamilyList all;
    for (const auto& [file, text] : kBuiltInFamilyFiles) all.append(parseFamilies(text, file));
    needSections(all, all.code);
    return all;
  }();
  return families;
}

}  // namespace gluray::gl
