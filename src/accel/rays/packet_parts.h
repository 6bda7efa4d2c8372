// Packets of sixteen rays in the widths that Embree handles natively. Private to accel/; any thread.
#pragma once
#include "accel/rays/ray_packet.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gluray::accel {

/// Copies lanes [first, first + width) of a wide packet into a narrow one, calls ask(valid, narrow), and
/// copies them back. Both packets consist of `rows` rows that hold one 4-byte value for each lane.
template <class Narrow, int width, class Ask>
void askPart(void* wide, size_t rows, const int32_t* valid, int first, Ask&& ask) {
  Narrow narrow;
  auto* wideRows = static_cast<std::byte*>(wide) + static_cast<size_t>(first) * 4;
  auto* narrowRows = reinterpret_cast<std::byte*>(&narrow);
  const auto wideRow = [&](size_t row) { return wideRows + row * kLanes * 4; };
  const auto narrowRow = [&](size_t row) { return narrowRows + row * width * 4; };
  for (size_t row = 0; row < rows; ++row) std::memcpy(narrowRow(row), wideRow(row), width * 4);
  alignas(64) int32_t narrowValid[width];
  std::memcpy(narrowValid, valid + first, sizeof(narrowValid));
  ask(narrowValid, narrow);
  for (size_t row = 0; row < rows; ++row) std::memcpy(wideRow(row), narrowRow(row), width * 4);
}

/// Calls ask(valid, packet) for the wide packet, or for its parts where the processor handles fewer rays at
/// once.
template <class Wide, class Eight, class Four, class Packet, class Ask>
void askInWidth(int width, Packet& packet, size_t rows, const int32_t* valid, Ask&& ask) {
  static_assert(alignof(Packet) >= alignof(Wide) && sizeof(Packet) >= sizeof(Wide));
  if (width == 16) return ask(valid, reinterpret_cast<Wide&>(packet));
  for (int first = 0; first < kLanes; first += width) {
    if (width == 8)
      askPart<Eight, 8>(&packet, rows, valid, first, ask);
    else
      askPart<Four, 4>(&packet, rows, valid, first, ask);
  }
}

}  // namespace gluray::accel
