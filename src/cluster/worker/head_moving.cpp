// Moving images of a head's programs: their light is smoothed in a visibility buffer, across the tiles of all
// ranks.
#include "cluster/worker/head.h"

namespace gluray::cluster {

RequestedImage::Kind Head::kindOf(const ConnectedProgram& program) const {
  if (!program.isWhole()) return RequestedImage::Kind::alone;
  // What earlier frames know is of no use where pages come and go.
  if (program.paged) return RequestedImage::Kind::paged;
  if (!program.request->moving) return RequestedImage::Kind::shared;
  // One rank needs no visibility for others.
  return ranks_.size() == 1 ? RequestedImage::Kind::alone : RequestedImage::Kind::moving;
}

MovingOrder Head::movingOrderOf(ConnectedProgram& program) {
  const ConnectedProgram::Animation& animation = program.animations[program.request->view];
  const render::MovingRays rays = animation.pace.rays();
  return {true, animation.frames, rays.perPixel, rays.quarter};
}

void Head::receive(int rank, const CollectedTile& tile, double now) {
  states_.heard(rank, now);
  ConnectedProgram* const program = programOf(tile.id);
  if (!program) return;
  RequestedImage& image = *program->image;
  try {
    image.addTile(rank, tile, now);
  } catch (const Malformed&) {
    image.drop(rank);
    return goOn(*program, now);
  }
  // The other ranks have as much as before.
  if (!image.isCollected()) return giveTiles(image, rank);
  goOn(*program, now);
}

void Head::goOn(ConnectedProgram& program, double now) {
  const RequestedImage& image = *program.image;
  if (image.isLost()) return traceAlone(program, now);
  if (image.isCollected()) return giveVisibility(program, now);
  giveTiles(program);
}

void Head::giveVisibility(ConnectedProgram& program, double now) {
  RequestedImage& image = *program.image;
  const Array visibility = image.giveVisibility(now);
  bool all = true;
  for (int rank = 0; rank < ranks_.size(); ++rank) all = all && image.takesPart(rank);
  if (all) broadcastVisibility(program, visibility);  // a rank that does not answer would hold it up
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    if (!image.takesPart(rank)) continue;
    VisibilityReady comes{image.id(), image.toColor(rank), program.visibility.value_or(Hash128()), {}};
    // The image may end before a broadcast reaches a rank that colours nothing.
    if (!all || comes.tiles.empty())
      comes.visibility.assign(visibility.bytes.begin(), visibility.bytes.end());
    ranks_.send(rank, forRanks(comes));
  }
}

void Head::broadcastVisibility(ConnectedProgram& program, const Array& visibility) {
  const uint64_t number[] = {program.image->id(), static_cast<uint64_t>(ranks_.rank())};
  program.visibility = hashBytes(number, sizeof number);
  // Once until it has been broadcast, once until forgetVisibility().
  for (int i = 0; i < 2; ++i) store_.put(ranks_.rank(), *program.visibility, visibility);
  ranks_.send(kCoordinator, forRanks(TurnWanted{*program.visibility, visibility.bytes.size()}));
}

void Head::forgetVisibility(ConnectedProgram& program) {
  if (!program.visibility) return;
  for (int rank = 0; rank < ranks_.size(); ++rank) ranks_.send(rank, forRanks(Forget{{*program.visibility}}));
  program.visibility.reset();
}

void Head::traceAlone(ConnectedProgram& program, double now) {
  const bool averages = program.image->averages();
  end(program);
  start(program, RequestedImage::Kind::alone, averages, now);
}

}  // namespace gluray::cluster
