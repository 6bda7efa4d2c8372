#include "tests/fuzz/scenes/shrink.h"

#include <algorithm>
#include <optional>

namespace gluray::fuzz {
namespace {

Role closerOf(Role opener) {
  switch (opener) {
    case Role::begin: return Role::end;
    case Role::newList: return Role::endList;
    case Role::push: return Role::pop;
    default: return Role::other;
  }
}

using Calls = std::vector<Call>;

/// The number of the call that closes what call `at` opens.
std::optional<size_t> closedAt(const Calls& calls, size_t at) {
  const Role opener = calls[at].role, closer = closerOf(opener);
  size_t depth = 0;
  for (size_t i = at; closer != Role::other && i < calls.size(); ++i) {
    depth += calls[i].role == opener;
    if (calls[i].role == closer && --depth == 0) return i;
  }
  return std::nullopt;
}

Calls without(const Calls& calls, size_t first, size_t end) {
  Calls less = calls;
  less.erase(less.begin() + static_cast<ptrdiff_t>(first), less.begin() + static_cast<ptrdiff_t>(end));
  return less;
}

}  // namespace

bool isBalanced(const Calls& calls) {
  std::vector<const Call*> open;
  for (const Call& call : calls) {
    if (closerOf(call.role) != Role::other) open.push_back(&call);
    if (call.role == Role::vertex && (open.empty() || open.back()->role != Role::begin)) return false;
    if (call.role != Role::end && call.role != Role::endList && call.role != Role::pop) continue;
    if (open.empty() || closerOf(open.back()->role) != call.role || open.back()->pair != call.pair)
      return false;
    open.pop_back();
  }
  return open.empty();
}

Calls shrink(Calls calls, const std::function<bool(const Calls&)>& differs) {
  // Two primitives never become one, which might give vertices attributes that the first ones lack.
  for (size_t at = 0; at < calls.size(); ++at)
    if (const auto closer = closedAt(calls, at)) calls[at].pair = calls[*closer].pair = at + 1;
  const auto take = [&](Calls&& less) {
    if (!isBalanced(less) || !differs(less)) return false;
    calls = std::move(less);
    return true;
  };
  for (size_t before = calls.size() + 1; calls.size() < before;) {
    before = calls.size();
    for (size_t at = 0; at < calls.size(); ++at)  // all of a primitive, a list, an object
      if (const auto closer = closedAt(calls, at))
        if (take(without(calls, at, *closer + 1))) --at;
    for (size_t chunk = std::max<size_t>(1, calls.size() / 2);; chunk /= 2) {
      for (size_t at = 0; at < calls.size();)
        if (!take(without(calls, at, std::min(calls.size(), at + chunk)))) at += chunk;
      if (chunk == 1) break;
    }
    for (size_t at = 0; at < calls.size(); ++at)  // the pair alone
      if (const auto closer = closedAt(calls, at))
        if (take(without(without(calls, *closer, *closer + 1), at, at + 1))) --at;
  }
  return calls;
}

}  // namespace gluray::fuzz
