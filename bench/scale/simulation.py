"""SIMULATED frames of a job of many ranks: the protocol of src/cluster/worker with one head, over a LogGP link, as discrete events.

The main thread of each rank sends what its tracing threads have finished, handles the messages that have arrived, and sleeps: until the
next tile is finished, or for `sleep_us` (cluster::Worker::wait). The head sends the snapshot to all ranks, gives them tiles by
scale.shares.Shares, puts the tiles that come back into the image, and ends it. Times in microseconds; the same input gives the same result.
"""
import dataclasses
import heapq
import itertools
import math

from scale.shares import Shares


@dataclasses.dataclass(frozen=True)
class Costs:
    """Measured inputs (gluray-bench-tiles, gluray-bench-link)."""
    before: list     # microseconds of each tile in the frame before, which shares are made from
    tiles: list      # in this frame
    begin: float     # of a rank's image before its first tile
    end: float       # after its last one
    pack: float      # of a tile's pixels
    take: float      # of a traced tile at the head
    give: float      # of the head, for the next tiles of the rank that it came from
    sleep: float     # of a main thread that nothing wakes
    look: float      # of a main thread each time that it looks, beside what it finds
    wake: float      # from the end of a tile until the main thread knows
    bytes: dict      # of messages


@dataclasses.dataclass
class Result:
    frame: float     # from the program's request until its image is whole
    busy: list       # tracing time of each rank, all threads
    head: float      # time that the head's main thread worked
    looks: int       # of the head's main thread, but for those that find nothing
    head_link: float  # time that messages took on the head's port, inwards

    @property
    def balance(self):
        """Busiest rank over the mean."""
        return max(self.busy) * len(self.busy) / sum(self.busy)


class _Rank:
    def __init__(self, number, threads, sleep):
        self.free_threads = threads
        self.began = False
        self.tiles = []      # given and not begun, last one first
        self.inbox = []      # (arrival, order, kind, content)
        self.outbox = []     # messages to the head
        self.looked = -sleep * ((number * 0.6180339887) % 1)  # end of the last look: phases differ
        self.next_look = math.inf
        self.port_out = self.port_in = 0.0
        self.busy = self.work = self.received = 0.0
        self.looks = 0


class Job:
    def __init__(self, costs, link, ranks, threads):
        self.c, self.link, self.threads = costs, link, threads
        self.ranks = [_Rank(number, threads, costs.sleep) for number in range(ranks)]
        self.shares = Shares(costs.before, ranks, threads)
        self.order = itertools.count()
        self.events = []
        self.frame = None

    def run(self):
        self._post(0.0, 0, "request", None)
        while self.frame is None:
            time, _, what, rank, content = heapq.heappop(self.events)
            getattr(self, "_at_" + what)(time, rank, content)
        head = self.ranks[0]
        return Result(self.frame, [rank.busy for rank in self.ranks], head.work, head.looks, head.received)

    # Events.

    def _at(self, time, what, rank, content=None):
        heapq.heappush(self.events, (time, next(self.order), what, rank, content))

    def _at_look(self, time, number, _):
        rank = self.ranks[number]
        if time != rank.next_look:
            return  # another look came before
        rank.next_look = math.inf
        now = time + self.c.look
        rank.looks += 1
        while True:
            for kind, size, content in rank.outbox:
                now = self._send(now, number, 0, kind, size, content)
            rank.outbox = []
            if not rank.inbox or rank.inbox[0][0] > now:
                break
            _, _, kind, content = heapq.heappop(rank.inbox)
            now = getattr(self, "_take_" + kind)(now, number, content)
        rank.work += now - time
        rank.looked = now
        if rank.inbox:
            self._look_by_sleep(number, rank.inbox[0][0])

    def _at_tile_done(self, time, number, tile):
        rank = self.ranks[number]
        rank.free_threads += 1
        self._begin_tiles(time, number)
        self._push(time, number, ("tile", self.c.bytes["tile"], (number, tile)))

    def _at_began(self, time, number, _):
        self.ranks[number].began = True
        self._begin_tiles(time, number)

    def _at_tiles(self, time, number, tiles):
        self.ranks[number].tiles[:0] = reversed(tiles)
        self._begin_tiles(time, number)

    def _at_ended(self, time, number, _):
        self._push(time, number, ("finished", self.c.bytes["finished"], number))

    # Threads and main threads.

    def _begin_tiles(self, time, number):
        rank = self.ranks[number]
        while rank.began and rank.free_threads and rank.tiles:
            rank.free_threads -= 1
            tile = rank.tiles.pop()
            rank.busy += self.c.tiles[tile]
            self._at(time + self.c.tiles[tile] + self.c.pack, "tile_done", number, tile)

    def _push(self, time, number, message):
        rank = self.ranks[number]
        rank.outbox.append(message)
        self._look_at(number, max(time + self.c.wake, rank.looked))

    def _look_at(self, number, time):
        rank = self.ranks[number]
        if time < rank.next_look:
            rank.next_look = time
            self._at(time, "look", number)

    def _look_by_sleep(self, number, arrival):
        """The look at the end of the sleep in which a message arrives."""
        rank = self.ranks[number]
        sleeps = max(math.ceil((arrival - rank.looked) / self.c.sleep), 1)
        self._look_at(number, rank.looked + sleeps * self.c.sleep)

    def _post(self, arrival, number, kind, content):
        heapq.heappush(self.ranks[number].inbox, (arrival, next(self.order), kind, content))
        self._look_by_sleep(number, arrival)

    def _send(self, now, number, to, kind, size, content):
        """When the sender goes on."""
        if number == to:  # a queue, no message
            heapq.heappush(self.ranks[to].inbox, (now, next(self.order), kind, content))
            return now
        link, sender, receiver = self.link, self.ranks[number], self.ranks[to]
        now += link.send_us
        takes = max(link.gap_us, size * link.gap_per_byte_ns / 1000)
        sender.port_out = max(now, sender.port_out) + takes
        # Bytes stream through: the receiver's port is busy with them L later.
        receiver.port_in = max(sender.port_out + link.latency_us, receiver.port_in + takes)
        receiver.received += takes
        self._post(receiver.port_in, to, kind, content)
        return now

    # What main threads do with messages; each returns when it is done.

    def _received(self, now, sender, number):
        return now if sender == number else now + self.link.receive_us

    def _take_request(self, now, _, __):
        for to in range(len(self.ranks)):
            now = self._send(now, 0, to, "order", self.c.bytes["order"], None)
        return self._give(now)

    def _give(self, now):
        for to, tiles in self.shares.more_for_all():
            now = self._send(now, 0, to, "more", self.c.bytes["more"] + self.c.bytes["more_per_tile"] * len(tiles), tiles)
        return now

    def _take_order(self, now, number, _):
        now = self._received(now, 0, number)
        self._at(now + self.c.wake + self.c.begin, "began", number)
        return self._send(now, number, 0, "alive", self.c.bytes["alive"], number)

    def _take_alive(self, now, _, sender):
        return self._received(now, sender, 0)

    def _take_more(self, now, number, tiles):
        now = self._received(now, 0, number)
        self._at(now + self.c.wake, "tiles", number, tiles)
        return now

    def _take_tile(self, now, _, content):
        sender, _tile = content
        now = self._received(now, sender, 0) + self.c.take
        self.shares.finish(sender)
        if self.shares.left:
            return self._give(now + self.c.give)
        for to in range(len(self.ranks)):
            now = self._send(now, 0, to, "end", self.c.bytes["end"], None)
        return now

    def _take_end(self, now, number, _):
        now = self._received(now, 0, number)
        self._at(now + self.c.wake + self.c.end, "ended", number)
        return now

    def _take_finished(self, now, _, sender):
        now = self._received(now, sender, 0)
        if sender == 0:
            self.frame = now
        return now


def simulate(costs, link, ranks, threads):
    """One frame."""
    return Job(costs, link, ranks, threads).run()
