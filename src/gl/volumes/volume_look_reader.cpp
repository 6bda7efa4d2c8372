#include "gl/volumes/volume_look_reader.h"

#include "gl/program_state/program_state.h"
#include "gl/volumes/label_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gluray::gl {
namespace {

using scene::VolumeChannels;

size_t channelsOf(VolumeChannels use, int stored) {
  switch (use) {
    case VolumeChannels::one:
    case VolumeChannels::table:
    case VolumeChannels::labels: return 1;
    case VolumeChannels::colorAndOpacity: return 2;
    case VolumeChannels::colors: return 4;
    default: return static_cast<size_t>(stored);
  }
}

}  // namespace

VolumeLookReader::VolumeLookReader(ShadowState& shadow, const UniformReader& uniforms, std::string& why)
    : shadow_(shadow),
      family_(shadow.program().known->family->volume),
      words_(shadow.program().known->words),
      uniforms_(uniforms),
      why_(why) {}

glm::vec4 VolumeLookReader::element(const FamilyValue& v, int number, const glm::vec4& otherwise) const {
  if (v.uniform.empty() || isPlaceholder(v.uniform)) return value(v, otherwise);
  return uniforms_.has(v.uniform) ? uniforms_.vector(v.uniform, number) : otherwise;
}

std::shared_ptr<const scene::VoxelGrid> VolumeLookReader::readVoxels(const std::string& sampler,
                                                                     scene::Texture& sampling) {
  const GLint unit = uniforms_.unit(sampler);
  if (unit < 0) return why_ = "sampler \"" + sampler + "\" is not active", nullptr;
  auto grid = shadow_.textures.voxels(shadow_.real, shadow_.rare(), unit, sampling, why_);
  if (!grid) return nullptr;
  using scene::Wrap;
  for (const Wrap wrap : {sampling.wrapS, sampling.wrapT, sampling.wrapR})
    if (wrap != Wrap::clampToEdge)
      return why_ = "the texture of its voxels is not clamped to its edge", nullptr;
  return grid;
}

bool VolumeLookReader::readGrid(scene::Volume& volume) {
  scene::Texture sampling;
  volume.grid = readVoxels(family_.grid, sampling);
  if (!volume.grid) return false;
  volume.linear = sampling.magFilter == scene::Filter::linear;
  volume.byteFilter = sampling.byteFilter && volume.grid->type == scene::VoxelGrid::Type::byte;
  const size_t channels = channelsOf(volume.use, volume.grid->channels);
  if (channels > static_cast<size_t>(volume.grid->channels))
    return refuse("its voxels have fewer components than it uses");
  volume.channels.resize(channels);
  return true;
}

bool VolumeLookReader::readMask(scene::Volume& volume) {
  if (!uniforms_.has(family_.mask)) return true;
  scene::Texture sampling;
  volume.mask = readVoxels(family_.mask, sampling);
  if (!volume.mask) return false;
  if (volume.mask->type != scene::VoxelGrid::Type::byte) return refuse("its mask has no bytes");
  volume.maskLinear = sampling.magFilter == scene::Filter::linear;
  return true;
}

bool VolumeLookReader::readTableTexture(const std::string& sampler, scene::Texture& texture) {
  const GLint unit = uniforms_.unit(sampler);
  if (unit < 0) return refuse("sampler \"" + sampler + "\" is not active");
  if (shadow_.textures.bound(shadow_.real, shadow_.rare(), unit, GL_SAMPLER_2D, texture) != Reason::traced ||
      !texture.image)
    return refuse("the texture of \"" + sampler + "\" is not traced");
  const bool plain = texture.wrapS == scene::Wrap::clampToEdge && texture.magFilter == texture.minFilter &&
                     texture.mipFilter == scene::MipFilter::none;
  return (plain && !texture.image->floats.empty()) ||
         refuse("the table of \"" + sampler + "\" has no floats, clamped to its edge");
}

bool VolumeLookReader::readTable(const std::string& sampler, int channels, scene::VolumeTable& table) {
  scene::Texture texture;
  if (!readTableTexture(sampler, texture)) return false;
  const scene::TextureImage& image = *texture.image;
  if (image.height != 1) return refuse("the table of \"" + sampler + "\" has several rows");
  table.channels = channels, table.linear = texture.magFilter == scene::Filter::linear;
  table.values.clear();
  for (const glm::vec4& texel : image.floats)
    for (int c = 0; c < channels; ++c) table.values.push_back(texel[c]);
  return true;
}

bool VolumeLookReader::readTable2D(const std::string& sampler, scene::Volume& volume) {
  if (volume.blend != scene::VolumeBlend::composite)
    return refuse("its table of two coordinates is blended in another way than composited");
  scene::Texture texture;
  if (!readTableTexture(sampler, texture)) return false;
  if (texture.wrapT != scene::Wrap::clampToEdge)
    return refuse("the table of \"" + sampler + "\" is not clamped to its edge");
  auto table = std::make_shared<scene::VolumeTable2D>();
  table->size = {texture.image->width, texture.image->height};
  table->linear = texture.magFilter == scene::Filter::linear;
  table->values = texture.image->floats;
  // Only samples with an opacity above 0 count, but for the one of a slice and those of labels.
  const bool positive = uniforms_.has(family_.slicePoint) || volume.use == VolumeChannels::labels;
  const auto isKnown = [&](const glm::vec4& v) {
    return std::isfinite(v.r + v.g + v.b + v.a) && (v.a >= 0 || !positive);
  };
  if (!std::all_of(table->values.begin(), table->values.end(), isKnown))
    return refuse("the table of \"" + sampler + "\" has opacities below 0, or values that are no numbers");
  volume.table = std::move(table);
  return true;
}

bool VolumeLookReader::readLabels(scene::Volume& volume) {
  if (uniforms_.has(family_.slicePoint)) return refuse("it has labels on a slice");
  if (!readTable2D(family_.labels, volume)) return false;
  scene::VolumeLabels& labels = volume.labels;
  scene::Texture sampling;
  labels.voxels = readVoxels(family_.mask, sampling);
  if (!labels.voxels) return false;
  if (labels.voxels->type != scene::VoxelGrid::Type::byte || sampling.magFilter != scene::Filter::nearest)
    return refuse("its labels are no bytes of which the nearest one counts");
  labels.share = value(family_.labelShare, glm::vec4(1)).x;
  LabelNumbers numbers;
  numbers.scale = value(family_.labelScale, glm::vec4(1)).x;
  numbers.bias = value(family_.labelBias, glm::vec4(0)).x;
  numbers.count = value(family_.labelCount, glm::vec4(0)).x;
  numbers.tableRows = volume.table->linear ? 0 : volume.table->size.y;
  const auto rows = labelRows(numbers);
  if (!rows) return refuse("rounding decides which labels its voxels have");
  if (labels.share != 0) labels.rows = *rows;
  return true;
}

bool VolumeLookReader::readChannelTables(scene::Volume& volume, size_t channel, const std::string& index) {
  scene::VolumeChannel& look = volume.channels[channel];
  const bool colored = uniforms_.has(family_.color) && volume.use != VolumeChannels::colors;
  if (colored && !readTable(family_.color + index, 3, look.color)) return false;
  if (!uniforms_.has(family_.gradientOpacity)) return true;
  auto table = std::make_shared<scene::VolumeTable>();
  if (!readTable(family_.gradientOpacity + index, 1, *table)) return false;
  look.gradientOpacity = std::move(table);
  return true;
}

/// Of independent channels, each has tables; otherwise the only ones stand in element 0.
bool VolumeLookReader::readTables(scene::Volume& volume) {
  if (volume.use == VolumeChannels::table) return readTable2D(family_.table, volume);
  const bool each = volume.use == VolumeChannels::independent;
  for (size_t c = 0; c < (each ? volume.channels.size() : 1); ++c) {
    const std::string index = each ? "[" + std::to_string(c) + "]" : "";
    const size_t opacity = each ? c : scene::opacityChannelOf(volume.use);
    if (!readTable(family_.opacity + index, 1, volume.channels[opacity].opacity)) return false;
    if (!readChannelTables(volume, c, index)) return false;
  }
  return true;
}

void VolumeLookReader::readNumbers(scene::Volume& volume) {
  volume.cellStep = value(family_.cellStep, glm::vec4(0)),
  volume.cellSpacing = value(family_.cellSpacing, glm::vec4(1));
  volume.averaged = value(family_.averaged, {0, 1, 0, 0});
  volume.colorScale = value(family_.colorScale, glm::vec4(1)).x,
  volume.colorBias = value(family_.colorBias, glm::vec4(0)).x;
  const glm::vec4 scale = value(family_.scale, glm::vec4(1)), bias = value(family_.bias, glm::vec4(0)),
                  weight = value(family_.weights, glm::vec4(1));
  for (size_t c = 0; c < volume.channels.size(); ++c) {
    scene::VolumeChannel& channel = volume.channels[c];
    const int i = static_cast<int>(c);
    channel.scale = scale[i], channel.bias = bias[i], channel.weight = weight[i];
    channel.range = element(family_.range, i, {0, 1, 0, 0});
  }
  const float last = static_cast<float>(volume.channels.size() - 1);
  volume.gradientChannel =
      static_cast<size_t>(std::clamp(value(family_.gradientChannel, glm::vec4(0)).x, 0.0f, last));
}

scene::VolumeLight VolumeLookReader::lightAt(int number, bool positional) const {
  const FamilyVolumeLight& names = family_.light;
  scene::VolumeLight light;
  light.ambient = element(names.ambient, number, glm::vec4(0));
  light.diffuse = element(names.diffuse, number, glm::vec4(1));
  light.specular = element(names.specular, number, glm::vec4(1));
  light.direction = glm::vec3(uniforms_.vector(names.direction, number));
  light.positional = positional;
  if (!positional) return light;
  light.position = glm::vec3(uniforms_.vector(names.position, number));
  if (uniforms_.has(names.attenuation))
    light.attenuation = glm::vec3(uniforms_.vector(names.attenuation, number));
  if (uniforms_.has(names.coneAngle)) light.coneAngle = uniforms_.number(names.coneAngle, number);
  if (uniforms_.has(names.exponent)) light.exponent = uniforms_.number(names.exponent, number);
  return light;
}

bool VolumeLookReader::readLights(scene::VolumeShading& shading) {
  const FamilyVolumeLight& names = family_.light;
  constexpr int kMostLights = 64;
  const int count = static_cast<int>(value(names.count, glm::vec4(0)).x),
            positional = static_cast<int>(value(names.positional, glm::vec4(0)).x);
  if (count < 0 || count > kMostLights) return refuse("it has too many lights");
  for (int i = 0; i < count; ++i) {
    const bool isPositional =
        uniforms_.has(names.isPositional) ? uniforms_.number(names.isPositional, i) != 0 : i < positional;
    shading.lights.push_back(lightAt(i, isPositional));
  }
  const auto texture = uniforms_.product(names.eyeFromTexture),
             gradient = uniforms_.product(names.eyeFromGradient);
  if (!texture || !gradient) return refuse("a matrix is not active");
  shading.eyeFromTexture = glm::mat4(*texture), shading.eyeFromGradient = glm::mat3(glm::mat4(*gradient));
  return true;
}

bool VolumeLookReader::readLight(scene::Volume& volume) {
  const FamilyVolumeLight& names = family_.light;
  if (!uniforms_.has(names.diffuse.uniform)) return true;
  using Model = scene::VolumeShading::Model;
  scene::VolumeShading& shading = volume.shading;
  shading.model = valueOfWord(words_, names.modelSlot, kVolumeLightings, names.model);
  if (!shading.enabled()) return true;
  shading.twoSided = !names.twoSided.empty() && uniforms_.integer(names.twoSided) != 0;
  for (size_t c = 0; c < volume.channels.size(); ++c) {
    scene::VolumeMaterial& material = volume.channels[c].material;
    const int i = static_cast<int>(c);
    material.ambient = element(names.materialAmbient, i, glm::vec4(0));
    material.diffuse = element(names.materialDiffuse, i, glm::vec4(1));
    material.specular = element(names.materialSpecular, i, glm::vec4(0));
    material.shininess = element(names.shininess, i, glm::vec4(1)).x;
  }
  if (!shading.isFromViewer()) return readLights(shading);
  shading.lights.push_back(lightAt(0, false));
  // A power of a number below 0.
  if (shading.model == Model::viewerHalfway && !shading.twoSided)
    return refuse("its highlights are undefined where gradients turn away from the viewer");
  return true;
}

bool VolumeLookReader::readCropping(scene::Volume& volume) {
  if (!uniforms_.has(family_.cropPlanes)) return true;
  const auto texture = uniforms_.product(family_.textureFromCrop);
  if (!texture || !uniforms_.has(family_.cropFlags)) return refuse("its cropping is not active as a whole");
  auto cropping = std::make_shared<scene::VolumeCropping>();
  for (int i = 0; i < 6; ++i) {
    glm::dvec4 point(0, 0, 0, 1);
    point[i / 2] = double{uniforms_.number(family_.cropPlanes, i)};
    point = *texture * point;
    cropping->planes[static_cast<size_t>(i)] =
        static_cast<float>(point.w != 0 ? point[i / 2] / point.w : point[i / 2]);
  }
  for (int i = 0; i < 27; ++i)
    cropping->kept[static_cast<size_t>(i)] = uniforms_.number(family_.cropFlags, i + 1) != 0;
  volume.cropping = std::move(cropping);
  return true;
}

bool VolumeLookReader::readContours(scene::Volume& volume) {
  if (volume.blend != scene::VolumeBlend::isosurface) return true;
  const glm::vec2 range = volume.channels.front().range;
  const int count = static_cast<int>(value(family_.contourCount, glm::vec4(0)).x);
  for (int i = 0; i < count; ++i)
    volume.contours.push_back((uniforms_.number(family_.contours, i) - range.x) / (range.y - range.x));
  const bool finite = std::all_of(volume.contours.begin(), volume.contours.end(),
                                  [](float v) { return std::abs(v) < 1e20f; });
  if (!finite || !std::is_sorted(volume.contours.begin(), volume.contours.end()))
    return refuse("its contours are not in ascending order");
  return true;
}

bool VolumeLookReader::readScalars(scene::Volume& volume) {
  volume.blend = valueOfWord(words_, family_.blendSlot, kVolumeBlends, family_.blend);
  if (!takesLevels(volume.blend)) return refuse("its rays are blended in another way than by one map");
  if (!readGrid(volume)) return false;
  const FamilyVolumeLevels& levels = family_.levels;
  const bool first = valueOfWord(words_, levels.componentSlot, kVolumeComponents, levels.component) == 0;
  return first || volume.grid->grey || refuse("its voxels have no component of the one that it shows");
}

bool VolumeLookReader::read(scene::Volume& volume) {
  volume.blend = valueOfWord(words_, family_.blendSlot, kVolumeBlends, family_.blend);
  volume.use = valueOfWord(words_, family_.channelsSlot, kVolumeChannels, family_.channels);
  using scene::VolumeBlend;
  const bool mixed = volume.use == VolumeChannels::independent && volume.blend != VolumeBlend::isosurface;
  const bool single = volume.use == VolumeChannels::one || volume.use == VolumeChannels::table ||
                      volume.use == VolumeChannels::labels;
  if (!single && volume.blend != VolumeBlend::composite && !mixed)
    return refuse("several components of its voxels are blended in another way than composited");
  if (!readGrid(volume)) return false;
  if (volume.use == VolumeChannels::labels ? !readLabels(volume) : !readMask(volume)) return false;
  readNumbers(volume);
  return readTables(volume) && readLight(volume) && readCropping(volume) && readContours(volume);
}

}  // namespace gluray::gl
