#include "saved/layers/layer_list.h"

#include "base/printable.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace gluray::saved {
namespace {

struct LayerRow {
  Layer layer;
  std::string_view name, exrName, channels;
};

constexpr std::array<LayerRow, 6> kLayers = {{{Layer::albedo, "albedo", "albedo", "RGB"},
                                              {Layer::normal, "normal", "normal", "XYZ"},
                                              {Layer::position, "position", "position", "XYZ"},
                                              {Layer::depth, "depth", "depth", "Z"},
                                              {Layer::object, "object", "CryptoObject", "RGBA"},
                                              {Layer::material, "material", "CryptoMaterial", "RGBA"}}};

const LayerRow& rowOf(Layer layer) { return kLayers[static_cast<size_t>(layer)]; }

[[noreturn]] void refuse(std::string_view name) {
  std::string names;
  for (const LayerRow& row : kLayers) names += std::string(row.name) + ", ";
  throw std::runtime_error("--layers " + printable(std::string(name)) + ": use " + names + "or all");
}

}  // namespace

std::string_view nameOf(Layer layer) { return rowOf(layer).name; }

std::vector<std::string> channelsOf(Layer layer) {
  const LayerRow& row = rowOf(layer);
  const bool ranked = layer == Layer::object || layer == Layer::material;
  std::vector<std::string> names;
  for (int part = 0; part < (ranked ? kRanks / 2 : 1); ++part)
    for (const char channel : row.channels) {
      std::string name(row.exrName);
      if (ranked) name += '0', name += static_cast<char>('0' + part);
      names.push_back(name + '.' + channel);
    }
  return names;
}

std::vector<Layer> layersIn(std::string_view list) {
  std::array<bool, kLayers.size()> wanted{};
  while (!list.empty()) {
    const size_t comma = list.find(',');
    const std::string_view name = list.substr(0, comma);
    const auto found =
        std::find_if(kLayers.begin(), kLayers.end(), [&](const LayerRow& row) { return row.name == name; });
    if (name == "all")
      wanted.fill(true);
    else if (found == kLayers.end())
      refuse(name);
    else
      wanted[static_cast<size_t>(found->layer)] = true;
    if (comma == list.npos) break;
    list.remove_prefix(comma + 1);
    if (list.empty()) refuse("");
  }
  std::vector<Layer> layers;
  for (const LayerRow& row : kLayers)
    if (wanted[static_cast<size_t>(row.layer)]) layers.push_back(row.layer);
  return layers;
}

}  // namespace gluray::saved
