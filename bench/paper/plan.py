"""The rows of the paper's evaluation, and those that fit this machine.

A row is a data set in a program; each is measured with every engine, round by round.
"""
import dataclasses
import math

# The paper's Table 1: frames a second of a node with 8 cores of 2009 (7 threads trace), Mesa with one thread, a GPU of 2008.
PAPER_TABLE = {
    "PV-Wavelet": {"millions": 16, "gluray": 12.33, "mesa": 0.13, "gpu": 1.22},
    "VI-Wavelet": {"millions": 16, "gluray": 9.69, "mesa": 0.085, "gpu": 0.79},
    "PV-VPIC": {"millions": 102, "gluray": 5.02, "mesa": 0.026, "gpu": 0.08},
    "VI-VPIC": {"millions": 102, "gluray": 2.55, "mesa": 0.012, "gpu": 0.069},
    "EnSight-VPIC": {"millions": 102, "gluray": 6.94, "mesa": 0.02, "gpu": 0.23},
    "PV-RMI": {"millions": 316, "gluray": 2.53, "mesa": 0.014, "gpu": 0.027},
    "PV-RMO": {"millions": 316, "gluray": 3.22, "mesa": 0.009, "gpu": 0.026},
    "VAPOR-Star": {"millions": 86, "gluray": 2.39, "mesa": 0.025, "gpu": 0.67},
}
# Bytes a triangle that a program needs with GLuRay and with Mesa, mesh included, and those it needs anyway; measured, rounded up.
BYTES = {"ParaView": (220, 200), "VTK": (200, 180), "list": (140, 140), "elements": (170, 140), "immediate": (220, 130),
         "vbo": (75, 135)}
BUILD_BYTES = 165  # the same for the client if GLuRay may not choose a smaller structure
FIXED_BYTES = 1e9
FAR, CLOSE = 669.2, 150.0  # distances of the camera
SMALL_SCALE = 1 / 40
SMALL_SWEEP, FULL_SWEEP = (1, 4, 16), (1, 2, 4, 8, 16, 32, 64, 128, 256)
LARGE = 4  # millions from which the small version measures one round
TIMELINE_MILLIONS = 8  # of the paper's Figure 9


@dataclasses.dataclass(frozen=True)
class Row:
    scene: str      # PV-Wavelet ...: the paper's name of it, or Wavelet for those of its Figure 7 alone
    program: str    # ParaView, VTK or client
    path: str       # of the client: how it sends the mesh; otherwise the program's own way
    data: str       # data set of gluray-bench-paper-data
    millions: float  # of triangles, about
    distance: float = FAR

    @property
    def name(self):
        return f"{self.scene} {self.program} {self.path} {self.millions:g}M"

    def engine_needs(self, engine):
        """Bytes of memory with one engine."""
        with_gluray, with_mesa = BYTES[self.program if self.program != "client" else self.path]
        return FIXED_BYTES + self.millions * 1e6 * (with_gluray if engine in ("gluray", "auto") else with_mesa)

    @property
    def build_needs(self):
        """Bytes of memory for a given quality of the structure."""
        return FIXED_BYTES + self.millions * 1e6 * BUILD_BYTES

    @property
    def needs_bytes(self):
        """Bytes of memory with the hungriest engine."""
        return max(self.engine_needs("gluray"), self.engine_needs("mesa"))


# The program that stands for each program of the paper, and how it draws.
TABLE = {
    "PV-Wavelet": ("ParaView", "buffers", "wavelet", FAR),
    "VI-Wavelet": ("VTK", "buffers", "wavelet", FAR),
    "PV-VPIC": ("ParaView", "buffers", "plasma", FAR),
    "VI-VPIC": ("VTK", "buffers", "plasma", FAR),
    "EnSight-VPIC": ("client", "immediate", "plasma", FAR),
    "PV-RMI": ("ParaView", "buffers", "mixing", CLOSE),
    "PV-RMO": ("ParaView", "buffers", "mixing", FAR),
    "VAPOR-Star": ("client", "elements", "star", FAR),
}


def rounded(millions):
    """Rounds a requested size to two digits."""
    return float(f"{millions:.2g}") if millions < 100 else round(millions)


def fitting(row, memory_bytes):
    """The row, its size halved until it fits; None if 50,000 triangles do not fit."""
    while row.needs_bytes > memory_bytes:
        if row.millions < 0.1:
            return None
        row = dataclasses.replace(row, millions=rounded(row.millions / 2))
    return row


def rows(scale, sweep, memory_bytes):
    """(rows, notes about rows that do not fit): first the sweep of Figure 7, then Table 1."""
    planned, notes = [], []
    for millions in sweep:
        for row in (Row("Wavelet", "client", "list", "wavelet", millions),
                    Row("PV-Wavelet", *TABLE["PV-Wavelet"][:3], millions)):
            if row.needs_bytes > memory_bytes and row.path == "list":
                row = dataclasses.replace(row, path="vbo")  # needs less memory, so that the largest fits
            left_out = [title for engine, title in (("gluray", "GLuRay"), ("mesa", "Mesa")) if row.engine_needs(engine) > memory_bytes]
            if "GLuRay" not in left_out:
                planned.append(row)
            if row.program == "client" and "GLuRay" not in left_out and row.build_needs > memory_bytes:
                notes.append(f"{row.name} has no build of its own: that needs about {row.build_needs / 1e9:.0f} GB")
            if left_out:
                notes.append(f"{row.name} is left out with {' and '.join(left_out)}: it needs about {row.needs_bytes / 1e9:.0f} GB")
    for scene, (program, path, data, distance) in TABLE.items():
        # The Wavelet is small enough to be always that of the paper, if the sweep goes as far.
        asked = min(PAPER_TABLE[scene]["millions"], max(sweep)) if data == "wavelet" else PAPER_TABLE[scene]["millions"] * scale
        row = Row(scene, program, path, data, rounded(asked), distance)
        fits = fitting(row, memory_bytes)
        if fits is None:
            notes.append(f"{row.name} is left out: there is no memory for it")
        elif fits not in planned:
            planned.append(fits)
        if fits and fits != row:
            notes.append(f"{row.name} is measured with {fits.millions:g}M: it needs about {row.needs_bytes / 1e9:.0f} GB")
    return planned, notes


def rounds_of(row, rounds, full):
    return rounds if full or row.millions < LARGE else 1


def warm_seconds(millions):
    """How long GLuRay may draw before it is measured: until the better acceleration structure is in use."""
    return 1 + 0.6 * millions


def guess_seconds(row, engine, threads):
    """Rough estimate of a measurement's time, corrected later by real measurements."""
    start = {"ParaView": 3.0, "VTK": 1.0, "client": 0.3}[row.program] + row.millions * 0.1
    if engine in ("gluray", "auto"):
        return start + warm_seconds(row.millions) + 0.2 * row.millions + 2
    frame = max(0.25 * row.millions / (1 if engine == "mesa1" else min(threads, 3)), 0.05)
    return start + 2 * frame + max(2 * frame, 2) + math.log2(1 + row.millions)
