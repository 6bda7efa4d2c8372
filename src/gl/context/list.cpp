#include "gl/context/list.h"

#include "gl/context/context.h"

namespace gluray::gl {

FragmentOp::~FragmentOp() {
  if (const auto group = group_.lock()) group->discardRealList(realList_);
}

void FragmentOp::execute(Context& context) {
  context.immediate.closeRunOutsideBegin();
  // Between glBegin and glEnd the fragment may be legal: the real OpenGL takes over and decides.
  context.beforeForward(context.immediate.insideBegin() ? Context::Flush::none : Context::Flush::all);
  context.real.CallList(realList_);
  context.shadow.current.letGo();
  context.shadow.touch(kAllGroups);
  context.shadow.matrixMode = 0;
}

}  // namespace gluray::gl
