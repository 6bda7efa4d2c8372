// What generated stubs need of the shadow GL: the context, its gate, recording and protection.
#pragma once
#include "gl/handlers.h"
#include "gl/leaf.h"
#include "gl/list.h"
#include "gl/param_counts.h"

#include <exception>
#include <new>
#include <type_traits>

namespace gluray::gl {

template <class F>
void Context::record(F&& call, bool anywhere) {
  if (insideBegin()) return misuse();
  std::unique_ptr<ListOp> op;
  insist([&] { op = std::make_unique<CallOp<std::decay_t<F>>>(call, anywhere); });
  insist([&] { append(op); });
}

template <class F>
void Context::recordFragment(F&& call) {
  if (insideBegin()) return misuse();
  const GLuint id = real.GenLists(1);
  if (!id) return setError(GL_OUT_OF_MEMORY);
  real.NewList(id, GL_COMPILE);
  call();
  real.EndList();
  appendFragment(id);
}

}  // namespace gluray::gl
