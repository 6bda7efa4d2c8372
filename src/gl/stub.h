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
void Context::record(F&& call) {
  protect([&] {
    if (insideBegin()) return;  // the gate has refused everything that is illegal there
    append(std::make_unique<CallOp<std::decay_t<F>>>(std::forward<F>(call)));
  });
}

template <class F>
void Context::recordFragment(F&& call) {
  protect([&] {
    const GLuint id = real.GenLists(1);
    if (!id) throw std::bad_alloc();
    real.NewList(id, GL_COMPILE);
    call();
    real.EndList();
    append(std::make_unique<FragmentOp>(id, group_));
  });
}

}  // namespace gluray::gl
