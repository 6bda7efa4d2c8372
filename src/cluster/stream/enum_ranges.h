// Ranges of the enumerations of scenes, to check untrusted values. Any thread.
#pragma once
#include "scene/failure.h"
#include "scene/snapshot.h"

#include <type_traits>

namespace gluray::cluster {

/// The last enumerator; enumerators are contiguous from 0.
template <class E>
inline constexpr E kLast = E::no_range_is_known;

template <>
inline constexpr auto kLast<scene::Loss> = scene::Loss::tracing;
template <>
inline constexpr auto kLast<scene::CullFace> = scene::CullFace::both;
template <>
inline constexpr auto kLast<scene::GroundUse> = scene::GroundUse::drawn;
template <>
inline constexpr auto kLast<scene::Layers::Of> = scene::Layers::Of::drawn;
template <>
inline constexpr auto kLast<scene::LightSampling::Mode> = scene::LightSampling::Mode::noiseless;
template <>
inline constexpr auto kLast<scene::ColorMaterial::Mode> = scene::ColorMaterial::ambientAndDiffuse;
template <>
inline constexpr auto kLast<scene::Fog::Mode> = scene::Fog::exp2;
template <>
inline constexpr auto kLast<scene::AlphaTest::Function> = scene::AlphaTest::notEqual;
template <>
inline constexpr auto kLast<scene::FragmentLight::Kind> = scene::FragmentLight::positional;
template <>
inline constexpr auto kLast<scene::FragmentShading::Model> = scene::FragmentShading::Model::pbr;
template <>
inline constexpr auto kLast<scene::FragmentShading::Specular> = scene::FragmentShading::Specular::half;
template <>
inline constexpr auto kLast<scene::FragmentShading::Normals> = scene::FragmentShading::Normals::perTriangle;
template <>
inline constexpr auto kLast<scene::FragmentShading::Color> = scene::FragmentShading::Color::height;
template <>
inline constexpr auto kLast<scene::FragmentShading::UnitNormals> = scene::FragmentShading::UnitNormals::never;
template <>
inline constexpr auto kLast<scene::PbrSurface::Masking> = scene::PbrSurface::Masking::separate;
template <>
inline constexpr auto kLast<scene::TextureTarget> = scene::TextureTarget::rectangle;
template <>
inline constexpr auto kLast<scene::Wrap> = scene::Wrap::mirrorClampToBorder;
template <>
inline constexpr auto kLast<scene::Filter> = scene::Filter::linear;
template <>
inline constexpr auto kLast<scene::MipFilter> = scene::MipFilter::linear;
template <>
inline constexpr auto kLast<scene::BaseFormat> = scene::BaseFormat::rgba;
template <>
inline constexpr auto kLast<scene::LodRule> = scene::LodRule::llvmpipe;
template <>
inline constexpr auto kLast<scene::TexEnv> = scene::TexEnv::combine;
template <>
inline constexpr auto kLast<scene::Combine::Function> = scene::Combine::dot3Rgba;
template <>
inline constexpr auto kLast<scene::Combine::Operand> = scene::Combine::oneMinusAlpha;
template <>
inline constexpr auto kLast<scene::TexGen::Mode> = scene::TexGen::reflectionMap;
template <>
inline constexpr auto kLast<scene::Format> = scene::Format::bits8;
template <>
inline constexpr auto kLast<scene::Shape> = scene::Shape::sticks;
template <>
inline constexpr auto kLast<scene::FragmentShading::HighlightColor> =
    scene::FragmentShading::HighlightColor::complement;
template <>
inline constexpr auto kLast<scene::Impostors::Billboards> = scene::Impostors::Billboards::square;

template <class E>
constexpr bool isKnown(E value) {
  return static_cast<std::underlying_type_t<E>>(value) <= static_cast<std::underlying_type_t<E>>(kLast<E>);
}
constexpr bool isKnown(scene::BlendFactor f) {
  const auto value = static_cast<uint16_t>(f);
  return value <= 1 || (value >= 0x0300 && value <= 0x0308) || (value >= 0x8001 && value <= 0x8004);
}
constexpr bool isKnown(scene::BlendEquation e) {
  const auto value = static_cast<uint16_t>(e);
  return (value >= 0x8006 && value <= 0x8008) || value == 0x800A || value == 0x800B;
}

}  // namespace gluray::cluster
