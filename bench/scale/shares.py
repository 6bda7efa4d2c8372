"""Which rank traces which tiles: as src/cluster/shares/tile_shares.cpp, for ranks that are all there and equally fast."""

PART = 3  # a rank gets 1 / PART of what is left of its share


class Shares:
    def __init__(self, costs, ranks, threads):
        """`costs`: of each tile, as measured in the frame before."""
        self.costs = costs
        self.low = 2 * max(threads, 1)  # tiles that keep a rank's threads busy
        self.left = len(costs)
        self.pending = [0] * ranks
        self.rests = [[] for _ in range(ranks)]
        share = sum(costs) / ranks
        rank, before, end = 0, 0.0, share
        for tile, cost in enumerate(costs):
            while before + cost / 2 > end and rank + 1 < ranks:
                rank += 1
                end += share
            self.rests[rank].append(tile)
            before += cost
        self.rest_costs = [self._cost_of(rest) for rest in self.rests]
        self.to_give = len(costs)
        self.hungry = set(range(ranks))  # have less than `low`

    def _cost_of(self, tiles):
        return sum(self.costs[tile] for tile in tiles)

    def _take_from_others(self, rank):
        richest = max(range(len(self.rests)), key=self.rest_costs.__getitem__)
        rest = self.rests[richest]
        half = len(rest) // 2
        self.rests[rank], self.rests[richest] = rest[half:], rest[:half]
        for changed in (rank, richest):
            self.rest_costs[changed] = self._cost_of(self.rests[changed])

    def more(self, rank):
        """Tiles that the rank gets now; none: it has enough, or nothing is left."""
        if self.pending[rank] >= self.low or not self.to_give:
            return []
        if not self.rests[rank]:
            self._take_from_others(rank)
        rest = self.rests[rank]
        count = min(len(rest), max(self.low, len(rest) // PART))
        tiles, self.rests[rank] = rest[:count], rest[count:]
        self.rest_costs[rank] = self._cost_of(self.rests[rank])
        self.pending[rank] += count
        self.to_give -= count
        if self.pending[rank] >= self.low:
            self.hungry.discard(rank)
        return tiles

    def more_for_all(self):
        """(rank, tiles) of all ranks that get some now, in the order in which the head asks."""
        if not self.to_give:
            return []
        given = [(rank, self.more(rank)) for rank in sorted(self.hungry)]
        return [(rank, tiles) for rank, tiles in given if tiles]

    def finish(self, rank):
        """A rank has traced one of its tiles."""
        self.pending[rank] -= 1
        self.left -= 1
        if self.pending[rank] < self.low:
            self.hungry.add(rank)
