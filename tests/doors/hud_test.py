"""`--hud`: text in the lower left corner of the shown image, and nowhere else.

    hud_test.py GLURAY DOOR PROGRAM

PROGRAM read-after-swap writes what its window shows to standard output, as PPM. Needs an X server
(with_display.py).
"""
import subprocess
import sys

from compare_images import images

GROUND = bytes((0x18, 0x20, 0x30))  # src/intercept/hud/text_image.h
CORNER, LEAST = 8, 500              # where the text begins; least number of pixels of its background


def image(gluray, door, program, *options):
    done = subprocess.run([gluray, "--door", door, *options, "--", program, "read-after-swap"], stdout=subprocess.PIPE,
                          timeout=100, check=True)
    return images(done.stdout)[0]


def main():
    gluray, door, program = sys.argv[1:]
    width, height, plain = image(gluray, door, program, "--engine", "always")
    _, _, shown = image(gluray, door, program, "--engine", "always", "--hud")
    places = [(i % width, i // width) for i in range(width * height) if plain[3 * i:3 * i + 3] != shown[3 * i:3 * i + 3]]
    ground = sum(shown[3 * i:3 * i + 3] == GROUND for i in range(width * height))
    problems = []
    if ground < LEAST:
        problems.append(f"{ground} pixels of ground, {LEAST} expected")
    if places and (min(x for x, _ in places) != CORNER or min(y for _, y in places) != CORNER):
        problems.append("it is not in the lower left corner")  # glReadPixels: lowest row first
    if any(y > height // 3 or x > 2 * width // 3 for x, y in places):
        problems.append("the image differs elsewhere")
    print("\n".join(problems) or f"{len(places)} pixels of the corner differ")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
