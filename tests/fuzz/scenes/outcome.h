// The outcome of a random scene: query results, colours and depths; compared, and kept in files.
#pragma once
#include "tests/fuzz/scenes/scene.h"
#include "tests/support/drawn_image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::fuzz {

struct Outcome {
  std::vector<float> answers;
  test::DrawnImage image;
};

/// Draws the scene into the current framebuffer and reads it back.
Outcome outcomeOf(Gl gl, const std::vector<Call>& scene);

/// Empty if both agree, else the difference; their images then go to `folder` unless that is empty.
std::string difference(uint64_t seed, const Outcome& expected, const Outcome& got, const std::string& folder);

/// Writes or reads a scene's file in a folder. False if it cannot be written, or is incomplete.
bool save(const std::string& folder, uint64_t seed, const Outcome&);
bool load(const std::string& folder, uint64_t seed, Outcome&);

}  // namespace gluray::fuzz
