#include "gl/real/hidden_extensions.h"

#include "gl/real/state_queries.h"
#include "settings/quirks.h"

#include <GL/glext.h>

#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace gluray::gl {
namespace {

bool isHidden(std::string_view name) {
  return name == "GL_ARB_buffer_storage" || name == "GL_EXT_buffer_storage";
}

bool isHidden(const RealGl& real, GLint index) {
  const GLubyte* name = real.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(index));
  const bool hidden = name && isHidden(reinterpret_cast<const char*>(name));
  if (hidden) noteUse(Quirk::hidePersistentMapping);
  return hidden;
}

}  // namespace

const GLubyte* withoutHidden(const GLubyte* all) {
  if (!all) return nullptr;
  std::string_view rest = reinterpret_cast<const char*>(all);
  std::string shown;
  while (!rest.empty()) {
    const size_t end = rest.find(' ');
    const std::string_view name = rest.substr(0, end);
    rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
    if (isHidden(name))
      noteUse(Quirk::hidePersistentMapping);
    else if (!name.empty())
      shown.append(name).append(" ");
  }
  // Programs keep the pointer, so the text must stay where it is.
  static std::mutex mutex;
  static std::set<std::string> texts;
  const std::lock_guard lock(mutex);
  return reinterpret_cast<const GLubyte*>(texts.insert(shown).first->c_str());
}

GLint visibleExtensions(const RealGl& real) {
  const GLint all = integer(real, GL_NUM_EXTENSIONS);
  GLint shown = all;
  for (GLint i = 0; i < all; ++i) shown -= isHidden(real, i);
  return shown;
}

GLuint realExtensionIndex(const RealGl& real, GLuint index) {
  const GLint all = integer(real, GL_NUM_EXTENSIONS);
  for (GLint i = 0; i < all; ++i) {
    if (isHidden(real, i)) continue;
    if (index-- == 0) return static_cast<GLuint>(i);
  }
  return static_cast<GLuint>(all);
}

}  // namespace gluray::gl
