// What most tests include, compiled once for all of them (cmake/GlurayModule.cmake). Every test still
// includes what it uses: builds with clang have no precompiled headers.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>
