// Which rows of a table the bytes of a label map stand for. Any thread.
#pragma once
#include <array>
#include <optional>

namespace gluray::gl {

/// A byte's label is the whole part of (byte / 255 * scale + bias) * count.
struct LabelNumbers {
  float scale = 1, bias = 0;
  float count = 0;    // of labels; 0: no byte has one
  int tableRows = 0;  // of which the nearest one counts; 0: the table is filtered
};

/// For each byte, the coordinate of its row in the table, 0 .. 1: label / count; 0: it has no label.
/// nullopt: a number lies so near to a step that the rounding of the real OpenGL decides.
std::optional<std::array<float, 256>> labelRows(const LabelNumbers& numbers);

}  // namespace gluray::gl
