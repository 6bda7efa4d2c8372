// Layers of OpenEXR pictures: what can be asked for, and their channels. Any thread.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::saved {

enum class Layer : uint8_t { albedo, normal, position, depth, object, material };

inline constexpr int kRanks = 6;  // of Cryptomatte: surfaces that a pixel names

/// The layers that a list names ("albedo,depth", "all", ""), each once, in their own order. Throws
/// std::runtime_error with one line that lists all names.
std::vector<Layer> layersIn(std::string_view list);

std::string_view nameOf(Layer);
/// "albedo.R", "CryptoObject00.R" ...
std::vector<std::string> channelsOf(Layer);
/// Whether values are colours, for which 16 bits may do.
constexpr bool isColor(Layer layer) { return layer == Layer::albedo; }

}  // namespace gluray::saved
