// Checks which corners the triangles or quads of a billboard have.
#include "gl/impostors/sent_billboards.h"

#include <array>
#include <bit>

namespace gluray::gl {
namespace {

struct Corners3 {
  uint8_t at[3];
};

/// Winding of the triangle, +1 or -1, seen from the positive side of direction `b`. Its corners are three of
/// a square in the two directions after `b`.
int turnOf(const Corners3& t, int b, int directions) {
  const int first = directions == 2 ? 0 : (b + 1) % 3, second = directions == 2 ? 1 : (b + 2) % 3;
  const auto x = [&](int k) { return t.at[k] >> first & 1; };
  const auto y = [&](int k) { return t.at[k] >> second & 1; };
  return (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
}

/// The halves of a square, cut along a diagonal, that were found so far.
struct Square {
  int halves = 0, turns = 0;
  uint8_t missing = 0;  // the corner that the first half lacks

  /// The xor of a square's four corners is 0, so the xor of three corners is the fourth. `across`: bits of
  /// both directions.
  bool add(const Corners3& t, int turn, uint8_t across) {
    const uint8_t fourth = t.at[0] ^ t.at[1] ^ t.at[2];
    if (turn == 0 || ++halves > 2) return false;
    turns += turn;
    if (halves == 1) return missing = fourth, true;
    return (missing ^ fourth) == across;
  }
  bool whole(int turn) const { return halves == 2 && turns == 2 * turn; }
};

}  // namespace

bool coversBillboard(std::span<const uint8_t> corners, GLenum mode, int directions) {
  const size_t each = mode == GL_QUADS ? 4 : 3;
  if (corners.empty() || corners.size() % each != 0) return false;
  const uint8_t all = directions == 2 ? 3 : 7;
  std::array<Square, 6> sides;
  const auto add = [&](const Corners3& t) {
    if (directions == 2) return sides[0].add(t, turnOf(t, 2, 2), all);
    const auto same = static_cast<uint8_t>(all & ~((t.at[0] ^ t.at[1]) | (t.at[0] ^ t.at[2])));
    if (std::popcount(same) != 1) return false;
    const int b = std::countr_zero(same), up = t.at[0] >> b & 1;
    return sides[static_cast<size_t>(2 * b + up)].add(t, turnOf(t, b, 3) * (up ? 1 : -1), all & ~same);
  };
  for (const uint8_t c : corners)
    if (c > all) return false;
  for (size_t i = 0; i < corners.size(); i += each) {
    const uint8_t* c = &corners[i];
    if (!add({{c[0], c[1], c[2]}})) return false;
    if (each == 4 && !add({{c[0], c[2], c[3]}})) return false;
  }
  const int turn = sides[0].turns / 2;
  for (size_t i = 0; i < (directions == 2 ? 1u : 6u); ++i)
    if (!sides[i].whole(turn) || turn == 0) return false;
  return true;
}

}  // namespace gluray::gl
