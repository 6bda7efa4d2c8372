#include "gl/lists/list_compiler.h"

#include "gl/context.h"
#include "gl/handlers.h"
#include "gl/lists/geometry_run.h"
#include "gl/stub.h"

#include <GL/gl.h>

#include <utility>

namespace gluray::gl {

/// Executes a recorded step as if no list were being compiled. The stream must be empty, and is again
/// afterwards.
template <class F>
void ListCompiler::runDetached(F&& body) {
  auto compiled = std::exchange(list_, nullptr);
  c_.immediate.resumeExecuted();
  c_.updateAttention();
  const auto restore = [&] {
    list_ = std::move(compiled);
    c_.immediate.leaveExecuted();
    c_.immediate.startRun();
  };
  try {
    body();
    c_.immediate.settleExecuted();
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

void ListCompiler::append(std::unique_ptr<ListOp>& op) {
  if (!op) return;
  if (!list_) return std::exchange(op, nullptr)->execute(c_);
  if (c_.immediate.holdsAnything()) c_.immediate.closeRun();
  list_->makeRoom();
  ListOp& appended = *op;
  list_->append(std::move(op));
  executeAdded(appended);
}

void ListCompiler::misuse(GLenum error) {
  if (executing()) c_.setError(error);
  if (compiling() && misused_ == GL_NO_ERROR) misused_ = error;
}

GLenum ListCompiler::takeMisuse() { return std::exchange(misused_, GL_NO_ERROR); }

GeometryRun& ListCompiler::add(Captured&& run, const SlotValues& finals,
                               std::vector<InheritedSlot>&& inherited, PrimitiveClass kind) {
  list_->makeRoom();
  auto op =
      std::make_unique<GeometryRun>(std::move(run), finals, std::move(inherited), kind, c_.sharedGroup());
  GeometryRun& added = *op;
  list_->append(std::move(op));
  return added;
}

void ListCompiler::executeAdded(ListOp& op) {
  if (executing()) runDetached([&] { op.execute(c_); });
}

void ListCompiler::appendFragment(GLuint realList) {
  stencilSet(c_);  // nobody knows what is in it
  std::unique_ptr<ListOp> op;
  c_.insist([&] { op = std::make_unique<FragmentOp>(realList, c_.sharedGroup()); });
  c_.insist([&] { append(op); });
}

void ListCompiler::newList(GLuint name, GLenum mode) {
  if (name == 0) return c_.setError(GL_INVALID_VALUE);
  if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return c_.setError(GL_INVALID_ENUM);
  if (compiling() || c_.insideBegin()) return c_.setError(GL_INVALID_OPERATION);
  c_.immediate.closeRunIfOpen();
  list_ = std::make_shared<DisplayList>();
  name_ = name;
  mode_ = mode;
  c_.immediate.startRun();
}

void ListCompiler::endList() {
  if (!compiling()) return c_.setError(GL_INVALID_OPERATION);
  if (executing() && (c_.insideBegin() || c_.immediate.executedInside())) c_.setError(GL_INVALID_OPERATION);
  if (c_.immediate.inside() == Immediate::Inside::captured) c_.immediate.loosen();
  if (c_.insideBegin()) c_.immediate.end();  // in a fragment, which cannot stay open
  c_.immediate.recordRun();
  c_.group().lists.put(name_, list_);
  list_.reset();
  name_ = 0;
  mode_ = 0;
  c_.immediate.idle();
}

void ListCompiler::callList(GLuint name) {
  constexpr int kDeepest = 64;  // GL_MAX_LIST_NESTING: also what ends lists that call themselves
  const auto list = c_.group().lists.find(name);
  if (!list || depth_ >= kDeepest) return;
  c_.immediate.closeRunOutsideBegin();
  if (depth_ == 0 && !c_.insideBegin() && !c_.direct()) {
    c_.current.store(c_.real);
    c_.latch.called(c_.real);
  }
  ++depth_;
  try {
    list->execute(c_);
  } catch (...) {
    --depth_;
    throw;
  }
  --depth_;
}

}  // namespace gluray::gl
