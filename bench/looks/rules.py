"""What the figures of measure.py may be, and which rules the purpose of a look excludes."""
import math

LIMITS = {"brightness": (0.85, 1.15), "lost": (0, 0.01), "hue": (0, 6), "burnt": (0, 0.01), "order": (0.98, 1), "depth": (0.1, math.inf)}

SMOOTH = ("presentation", "figure", "poster", "streamlines", "molecule", "metal", "outdoor")  # looks with smooth edges: their pictures are compared with the program's own multisampled ones

OWN_LIGHT = "it keeps the program's own light, which is all at the viewer here"
REFLECTION = "metal mirrors the bright and dark parts of the studio"
# Rules that the purpose of a look excludes, and why.
NOT_KEPT = {
    "draft": {"depth": OWN_LIGHT},
    "ospray": {"depth": OWN_LIGHT + ": shadows of such a light are not visible, and these surfaces have no ambient light that occlusion could darken"},
    "honest": {"brightness": "the colours of the map without light are brighter than lit ones", "burnt": "colours of the map that are white or saturated are shown so"},
    "metal": {"lost": REFLECTION, "burnt": REFLECTION, "order": REFLECTION},
}
# Scenes for which a look is made, on which it keeps these rules, too.
PURPOSE = {"metal": ("bearing", "inward")}


def beyond(figures):
    """Names of the figures that are out of their limits."""
    return [name for name, (least, most) in LIMITS.items() if not least <= figures[name] <= most]


def misses(look, scene, figures):
    """Names of the figures that are out of their limits, and are not those that the look's purpose excludes."""
    excused = {} if scene in PURPOSE.get(look, ()) else NOT_KEPT.get(look, {})
    return [name for name in beyond(figures) if name not in excused]
