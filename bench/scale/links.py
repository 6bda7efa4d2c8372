"""Networks for the simulation, in the LogGP model: Alexandrov, Ionescu, Schauser, Scheiman, "LogGP: incorporating long messages into the LogP
model", SPAA 1995. Microseconds, and nanoseconds a byte for G.

L latency, o time of a call that sends or receives, g time between messages of one port, G time between bytes of one message.
"""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Link:
    name: str
    latency_us: float
    send_us: float
    receive_us: float
    gap_us: float
    gap_per_byte_ns: float
    source: str


# Published latencies are half round trips, L + 2o; they are taken for L, with the calls' time measured here on top of them.
PUBLISHED = {
    "qdr": {
        "name": "QDR InfiniBand", "latency_us": 1.75, "gap_us": 0.56, "gap_per_byte_ns": 0.25,
        "source": "L: 1.75 us half round trip of a send (octo.vmware.com/rdma-on-vsphere-status-and-future-directions, QDR InfiniBand); G: the data rate of "
                  "4x QDR, 32 Gbit/s after 8b/10b coding (InfiniBand specification), an upper bound; g: as of HDR"},
    "hdr": {
        "name": "HDR InfiniBand", "latency_us": 1.62, "gap_us": 0.56, "gap_per_byte_ns": 0.0426,
        "source": "L: 1.62 us, osu_latency; G: 23,477 MB/s, osu_mbw_mr of 8 MiB, two pairs of processes (techcommunity.microsoft.com, HPC performance "
                  "and scalability results with Azure HBv2 VMs, ConnectX-6, 2019); g: 1.78 million messages of one byte a second, osu_bw "
                  "(github.com/openucx/ucx/issues/8851)"},
}


def links(measured):
    """All links by key; `measured`: figures of gluray-bench-link."""
    calls = {"send_us": measured["send_us"], "receive_us": measured["receive_us"]}
    own = max(measured["half_round_trip_us"] - calls["send_us"] - calls["receive_us"], 0.0)
    shared = Link("shared memory", own, **calls, gap_us=measured["gap_us"], gap_per_byte_ns=measured["gap_per_byte_ns"],
                  source="measured on this machine by gluray-bench-link")
    return {"shm": shared, **{key: Link(**calls, **values) for key, values in PUBLISHED.items()}}
