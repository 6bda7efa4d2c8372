"""States: small scenes drawn by ParaView (pvbatch) or by plain VTK, each a function with a stage as its argument (stages.py).

    @state("pvbatch")
    def solid(stage):
        stage.show(Sphere())
        stage.orbit(3)

Read by runner.py, inside the program that draws, and by compare.py, which runs it and compares the images.
"""
import dataclasses
import importlib
import json
import math
import pathlib
import sys

STATES = {}
SHARES = pathlib.Path(__file__).parent / "shares.json"


@dataclasses.dataclass(frozen=True)
class State:
    name: str
    group: str             # the module of states/ that it stands in
    program: str           # "pvbatch", "vtk", "newer_vtk" (the one that ParaView brings), "mpi2", "mpi4" (pvbatch in as many processes) or
                           # "remote" (pvserver)
    draw: callable
    beyond: float          # share of an image's pixels that may differ by more than 8 of 255
    reason: str            # reason for a larger tolerance than usual
    min_share: float       # least share of the state's triangles that must be traced; None: what shares.json says, if anything
    outside: bool          # pixels away from every surface must be equal
    same_depth: bool       # depth is compared
    sends: int             # most bytes of buffers sent to the real OpenGL while only the camera moves
    close: bool = False    # only 0.01 % of an image's pixels may differ by more than 2 of 255


def state(program, beyond=0.0005, reason="", min_share=None, outside=True, same_depth=True, sends=0, close=False):
    """Registers the function below it, for one program or, under names of their own, for a tuple of them. `beyond` is at
    most 0.005; above 0.0005 it needs a reason."""
    if beyond > 0.005 or (beyond > 0.0005 and not reason):
        raise ValueError(f"a tolerance of {beyond} is too large, or lacks its reason")

    def register(draw):
        for one in program if isinstance(program, tuple) else (program,):
            name = draw.__name__ if one == program else f"{draw.__name__}_{one}"
            if name in STATES:
                raise ValueError(f"two states are named {name}")
            STATES[name] = State(name, draw.__module__, one, draw, beyond, reason, min_share, outside, same_depth, sends, close)
        return draw

    return register


def load():
    """All states by name. Their modules import neither ParaView nor VTK before a state is drawn."""
    folder = pathlib.Path(__file__).parent / "states"
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))
    for file in sorted(folder.glob("*.py")):
        importlib.import_module(file.stem)
    shares = json.loads(SHARES.read_text()) if SHARES.exists() else {}
    if not set(shares) <= set(STATES):
        raise ValueError(f"{SHARES} names states that do not exist: {sorted(set(shares) - set(STATES))}")
    for name, share in shares.items():
        if STATES[name].min_share is None:
            STATES[name] = dataclasses.replace(STATES[name], min_share=share)
    return STATES


def keep_shares(seen):
    """Makes the shares in `seen`, rounded down, the least that must be traced; other states keep theirs. States that are
    mostly rasterised (passes and overlays) get no such minimum."""
    shares = json.loads(SHARES.read_text()) if SHARES.exists() else {}
    for name, share in seen.items():
        least = math.floor(100 * share - 1) / 100
        shares.pop(name, None)
        if least >= 0.5:
            shares[name] = least
    SHARES.write_text(json.dumps(shares, indent=0, sort_keys=True) + "\n")
