#include "gl/lists/list.h"

#include "gl/context.h"

namespace gluray::gl {

FragmentOp::~FragmentOp() {
  if (const auto group = group_.lock()) group->discardRealList(realList_);
}

void FragmentOp::execute(Context& context) {
  // Called between glBegin and glEnd, it may hold what is legal there: the real OpenGL takes over and knows.
  context.beforeForward(context.immediate.insideBegin() ? Context::Flush::none : Context::Flush::all);
  context.real.CallList(realList_);
  context.touch(kAllGroups);
  context.shadow.matrixMode = 0;
}

}  // namespace gluray::gl
