#include "gl/basics/statistics.h"

namespace gluray::gl {

Statistics& Statistics::operator+=(const Statistics& o) {
  frames += o.frames, framesInFront += o.framesInFront, framesInMemory += o.framesInMemory;
  framesPassedThrough += o.framesPassedThrough;
  drawsTraced += o.drawsTraced, drawsRasterised += o.drawsRasterised;
  trianglesTraced += o.trianglesTraced, trianglesRasterised += o.trianglesRasterised;
  drawsLit += o.drawsLit, imagesRelit += o.imagesRelit;
  drawsCulled += o.drawsCulled, trianglesLeftOut += o.trianglesLeftOut;
  for (size_t i = 0; i < rasterisedBecause.size(); ++i) rasterisedBecause[i] += o.rasterisedBecause[i];
  flushes += o.flushes;
  repeated += o.repeated;
  meshesBuilt += o.meshesBuilt, meshBytes += o.meshBytes;
  captureSeconds += o.captureSeconds, buildSeconds += o.buildSeconds;
  traceSeconds += o.traceSeconds, presentSeconds += o.presentSeconds;
  blasBuilds += o.blasBuilds, blasRefinements += o.blasRefinements;
  lightPasses += o.lightPasses;
  if (o.lightNoise > lightNoise) lightNoise = o.lightNoise;
  if (o.blasRefining > blasRefining) blasRefining = o.blasRefining;
  if (o.bvhBytes > bvhBytes) bvhBytes = o.bvhBytes;  // not a sum: all contexts share one renderer
  return *this;
}

}  // namespace gluray::gl
