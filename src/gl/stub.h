// What generated stubs need of the shadow GL: the context, its gate, recording and protection.
#pragma once
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/handlers.h"
#include "gl/lists/list.h"
#include "gl/lists/param_counts.h"

#include <exception>
#include <new>
#include <type_traits>

namespace gluray::gl {

template <class F>
void ListCompiler::record(F&& call, bool anywhere) {
  if (c_.insideBegin()) return misuse();
  std::unique_ptr<ListOp> op;
  c_.insist([&] { op = std::make_unique<CallOp<std::decay_t<F>>>(call, anywhere); });
  c_.insist([&] { append(op); });
}

template <class F>
void ListCompiler::recordFragment(F&& call) {
  if (c_.insideBegin() || c_.immediate.executedInside()) return misuse();
  const GLuint id = c_.real.GenLists(1);
  if (!id) return c_.setError(GL_OUT_OF_MEMORY);
  c_.real.NewList(id, GL_COMPILE);
  call();
  c_.real.EndList();
  appendFragment(id);
}

}  // namespace gluray::gl
