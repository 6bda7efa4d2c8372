// Lists the members of all types in snapshots for serialisation: fields(archive, value) calls archive(member,
// ...) with all members. Structured bindings name them, so that a new member that is not listed here is a
// compiler error. Any thread.
#pragma once
#include "scene/backdrop.h"
#include "scene/secondary_scene.h"
#include "scene/snapshot.h"

#include <concepts>
#include <type_traits>

namespace gluray::cluster {

/// T, or const T.
template <class V, class T>
concept Like = std::same_as<std::remove_const_t<V>, T>;

void fields(auto& archive, Like<scene::Camera> auto& value) {
  auto& [clipFromEye, viewport, depthNear, depthFar, rowsFromTop, largestWins, depthsFromZero] = value;
  archive(clipFromEye, viewport, depthNear, depthFar, rowsFromTop, largestWins, depthsFromZero);
}
void fields(auto& archive, Like<scene::Region> auto& value) {
  auto& [x, y, width, height] = value;
  archive(x, y, width, height);
}
void fields(auto& archive, Like<scene::ColorWrites> auto& value) {
  auto& [red, green, blue, alpha] = value;
  archive(red, green, blue, alpha);
}
void fields(auto& archive, Like<scene::ObjectNumber> auto& value) {
  auto& [number] = value;
  archive(number);
}
void fields(auto& archive, Like<scene::PolygonOffset> auto& value) {
  auto& [factor, units, resolution, euclidean, floats] = value;
  archive(factor, units, resolution, euclidean, floats);
}
void fields(auto& archive, Like<scene::Blending::Part> auto& value) {
  auto& [equation, source, destination] = value;
  archive(equation, source, destination);
}
void fields(auto& archive, Like<scene::Blending> auto& value) {
  auto& [rgb, alpha, constant, hasAlpha, writesDepth] = value;
  archive(rgb, alpha, constant, hasAlpha, writesDepth);
}
void fields(auto& archive, Like<scene::Layers> auto& value) {
  auto& [of, opaqueDepth, tolerance, peels, colors, floatColors, halfFloats, blending, depthSteps] = value;
  archive(of, opaqueDepth, tolerance, peels, colors, floatColors, halfFloats, blending, depthSteps);
}
void fields(auto& archive, Like<scene::LightSampling> auto& value) {
  auto& [mode, pass, tiles, anew, aliased] = value;
  archive(mode, pass, tiles, anew, aliased);
}
void fields(auto& archive, Like<scene::Backdrop> auto& value) {
  auto& [isClear] = value;
  archive(isClear);
}

void fields(auto& archive, Like<scene::Light> auto& value) {
  auto& [ambient, diffuse, specular, position, spotDirection, spotExponent, spotCutoff, attenuation] = value;
  archive(ambient, diffuse, specular, position, spotDirection, spotExponent, spotCutoff, attenuation);
}
void fields(auto& archive, Like<scene::Material> auto& value) {
  auto& [ambient, diffuse, specular, emission, shininess] = value;
  archive(ambient, diffuse, specular, emission, shininess);
}
void fields(auto& archive, Like<scene::MaterialPair> auto& value) {
  auto& [front, back] = value;
  archive(front, back);
}
void fields(auto& archive, Like<scene::ColorMaterial> auto& value) {
  auto& [front, back] = value;
  archive(front, back);
}
void fields(auto& archive, Like<scene::Fog> auto& value) {
  auto& [mode, density, start, end, color, clampsSum, fromCoordinates, scaled, scale, extrapolates] = value;
  archive(mode, density, start, end, color, clampsSum, fromCoordinates, scaled, scale, extrapolates);
}
void fields(auto& archive, Like<scene::AlphaTest> auto& value) {
  auto& [function, asBytes, reference] = value;
  archive(function, asBytes, reference);
}
void fields(auto& archive, Like<scene::FragmentLight> auto& value) {
  auto& [kind, color, direction, position, attenuation, coneAngle, exponent, ownHighlight, highlight,
         shininess, half] = value;
  archive(kind, color, direction, position, attenuation, coneAngle, exponent, ownHighlight, highlight,
          shininess, half);
}
void fields(auto& archive, Like<scene::PbrEnvironment> auto& value) {
  auto& [worldFromEye, byHarmonics, harmonics, irradiance, prefiltered, brdf, maxLevel, intensity,
         diffuseF0] = value;
  archive(worldFromEye, byHarmonics, harmonics, irradiance, prefiltered, brdf, maxLevel, intensity,
          diffuseF0);
}
void fields(auto& archive, Like<scene::PbrSurface> auto& value) {
  auto& [masking, metallic, roughness, baseF0, edgeTint, emissive, ambient, occlusionStrength, normalScale,
         distributionFloor, textures, material, emission, normal, environment] = value;
  archive(masking, metallic, roughness, baseF0, edgeTint, emissive, ambient, occlusionStrength, normalScale,
          distributionFloor, textures, material, emission, normal, environment);
}
void fields(auto& archive, Like<scene::HeightColors> auto& value) {
  auto& [axis, scale, offset, exponent] = value;
  archive(axis, scale, offset, exponent);
}
void fields(auto& archive, Like<scene::Rim> auto& value) {
  auto& [on, mixes, color, exponent, opacity] = value;
  archive(on, mixes, color, exponent, opacity);
}
void fields(auto& archive, Like<scene::FragmentShading> auto& value) {
  auto& [model, specular, highlightColor, normals, color, colorIsDiffuseOnly, height, colorExponent, encoding,
         unitNormals, facesViewer, normalColors, rim, clampsColors, ignoresAlpha, twoSidedLights,
         highlightsInDark, infiniteViewer, clampsLight, darkBackFaces, flipBackFaces, flipsTriangles,
         parallelView, backMaterial, paintsBack, backColor, texturesOnBack, texturesFirst, texturesKeepAlpha,
         lights, map, matcap, backFactor, pbr, writesDepth, edges, edgesAlone, edgesGrow, edgeWidth,
         edgeOpacity, edgeColor] = value;
  archive(model, specular, highlightColor, normals, color, colorIsDiffuseOnly, height, colorExponent,
          encoding, unitNormals, facesViewer, normalColors, rim, clampsColors, ignoresAlpha, twoSidedLights,
          highlightsInDark, infiniteViewer, clampsLight, darkBackFaces, flipBackFaces, flipsTriangles,
          parallelView, backMaterial, paintsBack, backColor, texturesOnBack, texturesFirst, texturesKeepAlpha,
          lights, map, matcap, backFactor, pbr, writesDepth, edges, edgesAlone, edgesGrow, edgeWidth,
          edgeOpacity, edgeColor);
}
void fields(auto& archive, Like<scene::Combine::Argument> auto& value) {
  auto& [source, operand] = value;
  archive(source, operand);
}
void fields(auto& archive, Like<scene::Combine::Part> auto& value) {
  auto& [function, arguments, scale] = value;
  archive(function, arguments, scale);
}
void fields(auto& archive, Like<scene::Combine> auto& value) {
  auto& [rgb, alpha] = value;
  archive(rgb, alpha);
}
void fields(auto& archive, Like<scene::TexGen::Coordinate> auto& value) {
  auto& [mode, plane] = value;
  archive(mode, plane);
}
void fields(auto& archive, Like<scene::TexGen> auto& value) {
  auto& [coordinates] = value;
  archive(coordinates);
}
void fields(auto& archive, Like<scene::Texture> auto& value) {
  auto& [image, target, unit, wrapS, wrapT, wrapR, seamless, magFilter, minFilter, mipFilter, lodRule,
         lodBias, minLod, maxLod, maxAnisotropy, byteFilter, borderColor, env, combine, envColor, texGen,
         textureMatrix] = value;
  archive(image, target, unit, wrapS, wrapT, wrapR, seamless, magFilter, minFilter, mipFilter, lodRule,
          lodBias, minLod, maxLod, maxAnisotropy, byteFilter, borderColor, env, combine, envColor, texGen,
          textureMatrix);
}
void fields(auto& archive, Like<scene::Shading> auto& value) {
  auto& [lighting, smooth, twoSided, localViewer, separateSpecular, colorSum, normalize, rescaleNormal,
         colorMaterial, globalAmbient, lights, textures, fog, alphaTest, fragment] = value;
  archive(lighting, smooth, twoSided, localViewer, separateSpecular, colorSum, normalize, rescaleNormal,
          colorMaterial, globalAmbient, lights, textures, fog, alphaTest, fragment);
}

void fields(auto& archive, Like<scene::Impostors> auto& value) {
  auto& [billboards, parallelView, inside, hemispheres, fades, gaussian, antialiased, outline, radiusDivisor,
         axisMatrix, centerPlanes, billboardScale, lowpass, size, coordinateShift, grows, inPixels, longer,
         bulge, bulgeDepth, depthBias, radius, unlit, roundEnds, halvesBlend] = value;
  archive(billboards, parallelView, inside, hemispheres, fades, gaussian, antialiased, outline, radiusDivisor,
          axisMatrix, centerPlanes, billboardScale, lowpass, size, coordinateShift, grows, inPixels, longer,
          bulge, bulgeDepth, depthBias, radius, unlit, roundEnds, halvesBlend);
}
void fields(auto& archive, Like<scene::FramebufferCapture> auto& value) {
  auto& [viewport, depthNear, depthFar, region, offset, colors, depths, content] = value;
  archive(viewport, depthNear, depthFar, region, offset, colors, depths, content.low, content.high);
}
void fields(auto& archive, Like<scene::CapturedSurface> auto& value) {
  auto& [capture, clipFromObject] = value;
  archive(capture, clipFromObject);
}
void fields(auto& archive, Like<scene::SecondaryScene> auto& value) {
  // Snapshots with volumes are not sent.
  auto& [shadings, instances, blended, viewFromWorld, captured, captures, volumes, framebuffer] = value;
  archive(shadings, instances, blended, viewFromWorld, captured, captures, framebuffer);
}
void fields(auto& archive, Like<scene::Snapshot> auto& value) {
  auto& [frame, view, viewFrame, swaps, number, lightSampling, camera, eyeFromWorld, region, samples,
         samplePositions, polygonOffset, depthSteps, layers, wideColors, byteSamples, limitedSamples, encodes,
         colorWrites, laterWins, shadings, instances, volumes, secondaryScene, extent, ground, catches,
         backdrop, settings] = value;
  archive(frame, view, viewFrame, swaps, number, lightSampling, camera, eyeFromWorld, region, samples,
          samplePositions, polygonOffset, depthSteps, layers, wideColors, byteSamples, encodes, colorWrites,
          laterWins, shadings, instances, secondaryScene, extent, ground, catches, backdrop, settings);
}

}  // namespace gluray::cluster
