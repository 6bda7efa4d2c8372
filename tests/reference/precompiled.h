// What most tests of this folder include, compiled once for all of them. Every test still includes what it
// uses: builds with clang have no precompiled headers.
#pragma once
#include "tests/headers/precompiled.h"
#include "tests/reference/both.h"
#include "tests/support/traced_context.h"
