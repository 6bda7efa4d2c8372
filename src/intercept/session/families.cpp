#include "intercept/session/families.h"

#include "base/files.h"
#include "base/log.h"
#include "intercept/session/session.h"

#include <utility>
#include <vector>

namespace gluray::intercept {
namespace {

std::string contentsOf(const std::string& file) {
  constexpr size_t kMax = size_t{16} << 20;
  files::Content content = files::read(file, kMax);
  if (!content.why.empty()) throw gl::FamilyError(file + ": " + content.why);
  return std::move(content.text);
}

/// Removes a list whose families refer to code sections that no file contains, or whose slots have mistakes.
/// Returns whether there was one.
bool dropOneThatLacksCode(std::vector<gl::FamilyList>& lists, void (*complain)(const std::string& line)) {
  if (lists.empty()) return false;
  gl::FamilyList all = gl::builtInFamilies();
  gl::FamilyList before = all;
  for (const gl::FamilyList& list : lists) all.append(list);
  for (auto list = lists.begin(); list != lists.end(); ++list) {
    before.append(*list);
    try {
      gl::needSections(*list, all.code);
      gl::needSlots(gl::builtInFamilies(), list->code, before.code);
    } catch (const gl::FamilyError& error) {
      complain(error.what());
      lists.erase(list);
      return true;
    }
  }
  return false;
}

}  // namespace

std::shared_ptr<const gl::FamilyList> readFamilies(const std::vector<std::string>& files,
                                                   void (*complain)(const std::string& line)) {
  std::vector<gl::FamilyList> lists;
  for (const std::string& file : files) {
    try {
      lists.push_back(gl::parseFamilies(contentsOf(file), file));
    } catch (const gl::FamilyError& error) { complain(error.what()); }
  }
  while (dropOneThatLacksCode(lists, complain)) {}
  gl::FamilyList all;
  for (const gl::FamilyList& list : lists) all.append(list);
  if (all.empty()) return nullptr;
  all.append(gl::builtInFamilies());
  return std::make_shared<const gl::FamilyList>(std::move(all));
}

std::shared_ptr<const gl::FamilyList> families() {
  // Never destroyed: programs call OpenGL while they exit.
  static const auto& once = *new std::shared_ptr<const gl::FamilyList>(readFamilies(
      session().programFamilies, [](const std::string& line) { log::write(log::Level::warning, line); }));
  return once;
}

}  // namespace gluray::intercept
