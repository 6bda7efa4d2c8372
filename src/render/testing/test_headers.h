// What most tests of this room include, compiled once for all of them. Every test still includes what it
// uses: builds with clang have no precompiled headers.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/testing/test_trace.h"
#include "tests/headers/precompiled.h"
