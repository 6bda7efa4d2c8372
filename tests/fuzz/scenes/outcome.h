// What a random scene leaves: answers, colours and depths; compared, and kept in files.
#pragma once
#include "gl/real.h"
#include "tests/support/picture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::fuzz {

struct Outcome {
  std::vector<float> answers;
  test::Picture picture;
};

/// Draws the scene of `seed` into the current framebuffer and reads it back.
Outcome outcomeOf(const gl::RealGl& gl, uint64_t seed);

/// Empty where both agree, else why they do not; their pictures then go to `folder` unless that is empty.
std::string difference(uint64_t seed, const Outcome& expected, const Outcome& got, const std::string& folder);

/// The file of a scene in a folder. False where it cannot be written, or is not whole.
bool save(const std::string& folder, uint64_t seed, const Outcome&);
bool load(const std::string& folder, uint64_t seed, Outcome&);

}  // namespace gluray::fuzz
