// Checks the formats of a mesh's arrays. Any thread.
#pragma once
#include "cluster/stream/page_layout.h"
#include "scene/mesh.h"

#include <cstdint>
#include <initializer_list>

namespace gluray::cluster {

inline constexpr std::initializer_list<scene::Format> kColorFormats = {
    scene::Format::float3, scene::Format::float4, scene::Format::unorm8x4};
inline constexpr std::initializer_list<scene::Format> kTexcoordFormats = {
    scene::Format::float1, scene::Format::float2, scene::Format::float3, scene::Format::float4};

/// Throws Malformed if the attribute is present and has none of these formats.
void checkFormat(const scene::Attribute& attribute, std::initializer_list<scene::Format> formats);
/// Throws Malformed if a page cannot have arrays of these formats. The content is not loaded yet.
void checkPageFormats(const scene::Mesh& page, const TriangleArrays& ofTriangles);
/// Largest of `count` elements of an array of uint32; 0 if there are none.
uint32_t largest(const scene::Attribute& attribute, uint32_t count);

}  // namespace gluray::cluster
