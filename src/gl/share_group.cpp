#include "gl/share_group.h"

#include "gl/buffer.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {

bool ShareGroup::anyBuffersHeldBack() const {
  const auto all = buffers.all();
  return std::any_of(all.begin(), all.end(), [](const auto& b) { return b->heldBack(); });
}

void ShareGroup::discardRealList(GLuint id) {
  const std::lock_guard lock(mutex_);
  discarded_.push_back(id);
}

std::vector<GLuint> ShareGroup::takeDiscardedLists() {
  const std::lock_guard lock(mutex_);
  return std::exchange(discarded_, {});
}

}  // namespace gluray::gl
