#include "gl/context/list_compiler.h"

#include "gl/context/context.h"
#include "gl/context/geometry_run.h"
#include "gl/context/handlers.h"
#include "gl/context/stub.h"

#include <GL/gl.h>

#include <utility>

namespace gluray::gl {

/// Executes a recorded step as if no list were being compiled. The stream must be empty, and is empty after.
template <class F>
void ListCompiler::runDetached(F&& body) {
  auto compiled = std::exchange(list_, nullptr);
  detached_ = true;
  p_.immediate.resumeExecuted();
  p_.attention.update();
  const auto restore = [&] {
    list_ = std::move(compiled);
    detached_ = false;
    p_.immediate.leaveExecuted();
    p_.immediate.startRun();
  };
  try {
    body();
    p_.immediate.settleExecuted();
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

void ListCompiler::append(std::unique_ptr<ListOp>& op) {
  if (!op) return;
  if (!list_) return std::exchange(op, nullptr)->execute(p_.context);
  if (p_.immediate.holdsAnything()) p_.immediate.closeRun();
  list_->makeRoom();
  ListOp& appended = *op;
  list_->append(std::move(op));
  executeAdded(appended);
}

void ListCompiler::misuse(GLenum error) {
  if (executing()) p_.shadow.errors.set(error);
  if (compiling() && misused_ == GL_NO_ERROR) misused_ = error;
}

GLenum ListCompiler::takeMisuse() { return std::exchange(misused_, GL_NO_ERROR); }

GeometryRun& ListCompiler::add(CapturedVertices&& run, const SlotValues& finals,
                               std::vector<InheritedSlot>&& inherited, PrimitiveClass kind) {
  list_->makeRoom();
  auto op = std::make_unique<GeometryRun>(std::move(run), finals, std::move(inherited), kind,
                                          p_.shadow.sharedGroup);
  GeometryRun& added = *op;
  list_->append(std::move(op));
  return added;
}

void ListCompiler::executeAdded(ListOp& op) {
  if (executing()) runDetached([&] { op.execute(p_.context); });
}

GLuint ListCompiler::beginFragment() {
  if (p_.immediate.insideBegin() || p_.immediate.executedInside()) return misuse(), 0;
  const GLuint id = p_.shadow.real.GenLists(1);
  if (!id) return p_.shadow.errors.set(GL_OUT_OF_MEMORY), 0;
  p_.shadow.real.NewList(id, GL_COMPILE);
  return id;
}

void ListCompiler::appendInsisting(std::unique_ptr<ListOp>& op) {
  p_.failsafe.insist([&] { append(op); });
}

void ListCompiler::appendFragment(GLuint realList) {
  stencilSet(p_.context);  // its commands are unknown
  std::unique_ptr<ListOp> op;
  p_.failsafe.insist([&] { op = std::make_unique<FragmentOp>(realList, p_.shadow.sharedGroup); });
  p_.failsafe.insist([&] { append(op); });
}

void ListCompiler::newList(GLuint name, GLenum mode) {
  if (name == 0) return p_.shadow.errors.set(GL_INVALID_VALUE);
  if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return p_.shadow.errors.set(GL_INVALID_ENUM);
  if (compiling() || p_.immediate.insideBegin()) return p_.shadow.errors.set(GL_INVALID_OPERATION);
  p_.immediate.closeRunIfOpen();
  p_.shadow.current.store(p_.shadow.real);
  list_ = std::make_shared<DisplayList>();
  name_ = name;
  mode_ = mode;
  p_.immediate.startRun();
}

void ListCompiler::endList() {
  if (!compiling()) return p_.shadow.errors.set(GL_INVALID_OPERATION);
  if (executing() && (p_.immediate.insideBegin() || p_.immediate.executedInside()))
    p_.shadow.errors.set(GL_INVALID_OPERATION);
  if (p_.immediate.inside() == Immediate::Inside::captured) p_.immediate.loosen();
  if (p_.immediate.insideBegin()) p_.immediate.end();  // a fragment cannot stay open
  p_.immediate.recordRun();
  p_.shadow.current.changeState(p_.shadow.real);
  p_.shadow.group.lists.put(name_, list_);
  p_.shadow.group.listLabels.erase(name_);  // a new object
  list_.reset();
  name_ = 0;
  mode_ = 0;
  p_.immediate.idle();
}

void ListCompiler::callList(GLuint name) {
  constexpr int kDeepest = 64;  // GL_MAX_LIST_NESTING; also ends the recursion of lists that call themselves
  p_.immediate.closeRunOutsideBegin();
  if (!p_.immediate.insideBegin()) p_.immediate.forgetAnswer();
  if (depth_ == 0 && !p_.immediate.insideBegin() && !p_.clock.passesThrough()) {
    p_.shadow.current.store(p_.shadow.real);
    p_.shadow.latch.called(p_.shadow.real);
  }
  const auto list = p_.shadow.group.lists.find(name);
  if (!list || depth_ >= kDeepest) return;
  ++depth_;
  try {
    list->execute(p_.context);
  } catch (...) {
    --depth_;
    throw;
  }
  --depth_;
}

}  // namespace gluray::gl
