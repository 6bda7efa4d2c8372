#include "intercept/session/guarded.h"

#include <atomic>

namespace gluray::intercept {
namespace {

std::atomic<bool> g_forked = false;

}  // namespace

void noteFork() noexcept { g_forked = true; }

bool isForkedChild() noexcept { return g_forked; }

}  // namespace gluray::intercept
