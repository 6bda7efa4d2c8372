// Which macro cells of a volume show something with its transfer functions. Any thread.
#pragma once
#include "accel/volumes/macro_cells.h"
#include "scene/volumes/volume.h"

#include <cstdint>
#include <vector>

namespace gluray::render {

/// Whether a table has a value other than 0 for any coordinate in a range, in constant time.
class NonzeroRanges {
 public:
  explicit NonzeroRanges(const scene::VolumeTable& table);
  bool any(float least, float most) const;

 private:
  std::vector<uint32_t> before_;  // values other than 0 before an entry
};

/// One byte a macro cell: 0 where samples can be seen, otherwise the distance to the nearest such cell in
/// cells (largest of the three axes), at most 255. `cells`: of each channel of the volume's grid.
std::vector<uint8_t> emptySpace(const std::vector<accel::MacroCells>& cells, const scene::Volume& volume);

}  // namespace gluray::render
