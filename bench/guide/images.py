#!/usr/bin/env python3
"""Makes the images of docs/guide/light.md: each scene with OpenGL's light and with effects, drawn by VTK under GLuRay.

python3 bench/guide/images.py [--build build/release] [--only NAME] [--pixels 420]
"""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench"))
sys.dont_write_bytecode = True
from support.display import NoDisplay, display  # noqa: E402
from support.options import Parser  # noqa: E402

OUT = ROOT / "docs" / "guide" / "light"
PATIENCE = 900  # seconds for one image
OCCLUSION = ["ao=on"]


def key(up, azimuth):
    """Soft shadows of a key light."""
    return ["shadows=on", "shadows.size=4", "lights=headlight+key", "lights.attached=scene", f"lights.up={up}", f"lights.azimuth={azimuth}"]


METAL = ["integrator=path", "path.depth=6", "environment=gradient", "environment.up=0,0,1", "environment.strength=0.6",
         "path.lights=0.5", f"material.file={ROOT / 'bench' / 'guide' / 'impact.toml'}"]
OUTDOORS = ["integrator=path", "path.depth=8", "path.lights=0", "environment=sky", "environment.up=0,0,1", "environment.sun=-0.7,0.6,0.5",
            "ground=plane", "lights.up=z", "background=environment", "denoise=filter"]
# Name of the image: scene, settings.
IMAGES = {
    "head": ("head", []),
    "head-ao": ("head", OCCLUSION),
    "head-key": ("head", [*OCCLUSION, *key("z", 165)]),
    "head-lens": ("head", [*OCCLUSION, "camera.aperture=6", "spp=64", "camera.focus-x=0.35", "camera.focus-y=0.4"]),
    "wavelet": ("wavelet", []),
    "wavelet-honest": ("wavelet", ["look=honest"]),
    "star": ("star", []),
    "star-ao": ("star", [*OCCLUSION, *key("y", 45)]),
    "impact": ("impact", []),
    "impact-key": ("impact", [*OCCLUSION, *key("z", -25)]),
    "impact-path": ("impact", METAL),
    "impact-ground": ("impact", ["shadows=on", "lights=sun", "lights.up=z", "lights.azimuth=-25", "ground=plane", "ground.color=#b8b0a0",
                                 "background=gradient", "ao=on", "ao.on=ambient"]),
    "head-catcher": ("head", [*OCCLUSION, *key("z", 165), "ground=catcher"]),
    "balls": ("balls", []),
    "balls-path": ("balls", [*OUTDOORS, f"material.file={ROOT / 'bench' / 'guide' / 'materials.toml'}"]),
}


def draw(build, name, pixels, screen):
    scene, settings = IMAGES[name]
    sets = [word for setting in settings for word in ("--set", setting)]
    command = [str(build / "apps" / "gluray" / "gluray"), *sets, "--", "/usr/bin/python3", str(ROOT / "bench" / "guide" / "draw.py"),
               scene, str(OUT / f"{name}.png"), str(pixels)]
    done = subprocess.run(command, env={**os.environ, "DISPLAY": screen}, timeout=PATIENCE, check=False)
    print(f"{name}: {'done' if done.returncode == 0 else f'failed ({done.returncode})'}", flush=True)
    return done.returncode == 0


def main():
    parser = Parser(__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--only", choices=sorted(IMAGES), help="make this image alone")
    parser.add_argument("--pixels", type=int, default=420, help="width and height")
    options = parser.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    try:
        with display() as screen:
            names = [options.only] if options.only else list(IMAGES)
            return 0 if all([draw(options.build.resolve(), name, options.pixels, screen) for name in names]) else 1
    except NoDisplay as error:
        print(f"images: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
