// What limits the images of a program with several ranks, from what its ranks spend. Any thread.
#pragma once
#include "cluster/messages/figure_messages.h"

#include <span>
#include <string>

namespace gluray::cluster {

/// One line, such as "rank 3 lit 2.1 times the average: uneven light" or "waiting for depths of other ranks:
/// 41 % of the time of rank 2". It names what the rank that works most does beyond the average, if that is
/// a fifth of its time; else what the rank that waits most waits for, if it waits a fifth of its time; else
/// what most of the work is. Says that nothing was measured if no rank has traced light across ranks.
std::string limitOf(std::span<const RankFigures> ranks);

}  // namespace gluray::cluster
