// Hits of one packet on one instance, and their colours, as rows of one value for each lane. Written by the
// kernels; integrators read and change the colours. Any thread.
#pragma once
#include "accel/rays/ray_packet.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::render {

using accel::kLanes;

/// One float for each lane; row[c] of several is component c.
using Row = float[kLanes];

/// Changes of the weights of a triangle's corners from one pixel to the next.
struct WeightSteps {
  glm::dvec3 x{0}, y{0};
};

/// The lanes of a packet that hit one instance. Lanes outside the group repeat a lane of it, so that every
/// load is valid.
struct Group {
  uint32_t lanes = 0;  // bit i: lane i belongs to the group
  alignas(64) uint32_t primitive[kLanes];
  alignas(64) uint32_t vertex[3][kLanes];
  alignas(64) Row position[3][3];  // [corner][component], object space
  alignas(64) Row u, v;
  // For impostors (impostor.inl.h): hit point and normal in lighting space, factors of colour and opacity.
  alignas(64) Row point[3], normal[3], fade, alpha;
  // One per lane: footprints of hits of secondary rays. Null: window positions determine footprints.
  const WeightSteps* steps = nullptr;
};

/// Colours of a packet: rows red, green, blue, alpha, and the secondary colour's three.
struct ColorRows {
  alignas(64) Row value[7];
};

}  // namespace gluray::render
