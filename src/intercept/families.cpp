#include "intercept/families.h"

#include "base/log.h"
#include "intercept/session.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace gluray::intercept {
namespace {

std::string contentsOf(const std::string& file) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(file, ignored);
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (in && !folder) text << in.rdbuf();
  if (folder) errno = EISDIR;
  if (folder || !in || in.bad()) throw gl::FamilyError(file + ": " + std::strerror(errno));
  return text.str();
}

}  // namespace

std::shared_ptr<const gl::FamilyList> readFamilies(const std::string& files,
                                                   void (*complain)(const std::string& line)) {
  gl::FamilyList all;
  std::istringstream names(files);
  for (std::string file; std::getline(names, file, ':');) {
    if (file.empty()) continue;
    try {
      all.append(gl::parseFamilies(contentsOf(file), file));
    } catch (const gl::FamilyError& error) { complain(error.what()); }
  }
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
