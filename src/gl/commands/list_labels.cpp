// Labels of display lists (GL 4.6 compatibility profile, section 20.9). The real OpenGL does not know the
// program's lists, so their labels are kept here. It knows all other objects.
#include "gl/context/handlers.h"
#include "gl/context/stub.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>

namespace gluray::gl {
namespace {

bool isOfList(const Context& c, GLenum identifier) { return identifier == GL_DISPLAY_LIST && !c.info().core; }

}  // namespace

void objectLabel(Context& c, GLenum identifier, GLuint name, GLsizei length, const GLchar* label) {
  if (!isOfList(c, identifier)) return c.real.ObjectLabel(identifier, name, length, label);
  if (!isList(c, name)) return c.errors.set(GL_INVALID_VALUE);
  NameTable<const std::string>& labels = c.shadow.group.listLabels;
  if (!label) return labels.erase(name);
  const size_t size = length < 0 ? std::strlen(label) : static_cast<size_t>(length);
  if (size >= static_cast<size_t>(integer(c.real, GL_MAX_LABEL_LENGTH)))
    return c.errors.set(GL_INVALID_VALUE);
  c.failsafe.insist([&] { labels.put(name, std::make_shared<const std::string>(label, size)); });
}

void getObjectLabel(Context& c, GLenum identifier, GLuint name, GLsizei size, GLsizei* length,
                    GLchar* label) {
  if (!isOfList(c, identifier)) return c.real.GetObjectLabel(identifier, name, size, length, label);
  if (size < 0 || !isList(c, name)) return c.errors.set(GL_INVALID_VALUE);
  const std::shared_ptr<const std::string> known = c.shadow.group.listLabels.find(name);
  size_t count = known ? known->size() : 0;
  if (label) {
    if (size == 0) return length ? void(*length = 0) : void();
    count = std::min(count, static_cast<size_t>(size) - 1);
    if (known) std::copy_n(known->data(), count, label);
    label[count] = 0;
  }
  if (length) *length = static_cast<GLsizei>(count);
}

}  // namespace gluray::gl
