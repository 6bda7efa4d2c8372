// Moving pictures of a head's programs: their light is smoothed on a film, across the tiles of all ranks.
#include "cluster/worker/head.h"

namespace gluray::cluster {

Picture::Kind Head::kindOf(const ConnectedProgram& program) const {
  if (!program.isWhole()) return Picture::Kind::alone;
  // What earlier frames know is of no use where pages come and go.
  if (program.paged) return Picture::Kind::paged;
  if (!program.request->moving) return Picture::Kind::shared;
  // One rank needs no film for others.
  return ranks_.size() == 1 ? Picture::Kind::alone : Picture::Kind::moving;
}

FilmOrder Head::filmOrderOf(ConnectedProgram& program) {
  const ConnectedProgram::Animation& animation = program.animations[program.request->view];
  const render::MovingRays rays = animation.pace.rays();
  return {true, animation.frames, rays.perPixel, rays.quarter};
}

void Head::receive(int rank, const FilmTile& tile, double now) {
  states_.heard(rank, now);
  ConnectedProgram* const program = programOf(tile.id);
  if (!program) return;
  Picture& picture = *program->picture;
  try {
    picture.addTile(rank, tile, now);
  } catch (const Malformed&) {
    picture.drop(rank);
    return goOn(*program, now);
  }
  // The other ranks have as much as before.
  if (!picture.isCollected()) return giveTiles(picture, rank);
  goOn(*program, now);
}

void Head::goOn(ConnectedProgram& program, double now) {
  const Picture& picture = *program.picture;
  if (picture.isLost()) return traceAlone(program, now);
  if (picture.isCollected()) return giveFilm(program, now);
  giveTiles(program);
}

void Head::giveFilm(ConnectedProgram& program, double now) {
  Picture& picture = *program.picture;
  const Array film = picture.giveFilm(now);
  bool all = true;
  for (int rank = 0; rank < ranks_.size(); ++rank) all = all && picture.takesPart(rank);
  if (all) broadcastFilm(program, film);  // a rank that does not answer would hold it up
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    if (!picture.takesPart(rank)) continue;
    FilmComes comes{picture.id(), picture.toColor(rank), program.film.value_or(Hash128()), {}};
    // The picture may end before a broadcast reaches a rank that colours nothing.
    if (!all || comes.tiles.empty()) comes.film.assign(film.bytes.begin(), film.bytes.end());
    ranks_.send(rank, forRanks(comes));
  }
}

void Head::broadcastFilm(ConnectedProgram& program, const Array& film) {
  const uint64_t number[] = {program.picture->id(), static_cast<uint64_t>(ranks_.rank())};
  program.film = hashBytes(number, sizeof number);
  // Once until it has been broadcast, once until forgetFilm().
  for (int i = 0; i < 2; ++i) store_.put(ranks_.rank(), *program.film, film);
  ranks_.send(kCoordinator, forRanks(TurnWanted{*program.film, film.bytes.size()}));
}

void Head::forgetFilm(ConnectedProgram& program) {
  if (!program.film) return;
  for (int rank = 0; rank < ranks_.size(); ++rank) ranks_.send(rank, forRanks(Forget{{*program.film}}));
  program.film.reset();
}

void Head::traceAlone(ConnectedProgram& program, double now) {
  const bool averages = program.picture->averages();
  end(program);
  start(program, Picture::Kind::alone, averages, now);
}

}  // namespace gluray::cluster
