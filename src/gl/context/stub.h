// The one header that generated stubs include: the context, its gate, recording into lists, protection.
#pragma once
#include "gl/capture/vertex_attribute_calls.h"
#include "gl/context/handlers.h"
#include "gl/context/list.h"
#include "gl/context/param_counts.h"

#include <exception>
#include <new>
#include <type_traits>

namespace gluray::gl {

template <class F>
void ListCompiler::record(F&& call, bool anywhere) {
  if (p_.immediate.insideBegin()) return misuse();
  std::unique_ptr<ListOp> op;
  p_.failsafe.insist([&] { op = std::make_unique<CallOp<std::decay_t<F>>>(call, anywhere); });
  appendInsisting(op);
}

template <class F>
void ListCompiler::recordFragment(F&& call) {
  const GLuint id = beginFragment();
  if (!id) return;
  call();
  p_.shadow.real.EndList();
  appendFragment(id);
}

}  // namespace gluray::gl
