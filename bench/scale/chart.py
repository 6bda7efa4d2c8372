"""Charts with two logarithmic axes as SVG. Equal input gives equal files."""
import dataclasses
import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT, LEFT, TOP = 400, 330, 58, 34  # of a panel, and the place of its axes in it; pixels
FONT = 'font-family="DejaVu Sans, sans-serif"'


@dataclasses.dataclass
class Series:
    title: str
    color: str
    points: list            # (x, y)
    marker: str = ""        # "circle", "square", "diamond"; empty: none
    dash: str = ""          # of the line
    line: bool = True


@dataclasses.dataclass
class Panel:
    title: str
    x_title: str
    y_title: str
    x_range: tuple
    y_range: tuple
    series: list


def _text(x, y, words, anchor="middle", size=11, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="#333" {FONT} {more}>{escape(words)}</text>'


def _marker(kind, x, y, color):
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}"/>'
    if kind == "square":
        return f'<rect x="{x - 3.5:.1f}" y="{y - 3.5:.1f}" width="7" height="7" fill="{color}"/>'
    return f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z" fill="{color}"/>'


def ticks(low, high, base):
    """Powers of `base` between two numbers; of 10 also twice and five times as much."""
    steps = (1, 2, 5) if base == 10 else (1,)
    first, last = math.floor(math.log(low, base)), math.ceil(math.log(high, base))
    found = [step * base**power for power in range(first, last + 1) for step in steps]
    return [tick for tick in found if low * 0.999 <= tick <= high * 1.001]


class _Axes:
    def __init__(self, panel, left, top):
        self.panel, self.left, self.top = panel, left + LEFT, top + TOP
        self.width, self.height = WIDTH - LEFT - 24, HEIGHT - TOP - 46

    def x(self, value):
        low, high = self.panel.x_range
        return self.left + self.width * math.log(value / low) / math.log(high / low)

    def y(self, value):
        low, high = self.panel.y_range
        return self.top + self.height * (1 - math.log(value / low) / math.log(high / low))

    def grid(self):
        right, bottom = self.left + self.width, self.top + self.height
        yield f'<rect x="{self.left}" y="{self.top}" width="{self.width}" height="{self.height}" fill="none" stroke="#999"/>'
        for tick in ticks(*self.panel.x_range, 2):
            yield f'<path d="M{self.x(tick):.1f} {self.top}V{bottom}" stroke="#e4e4e4"/>'
            yield _text(self.x(tick), bottom + 15, f"{tick:g}", size=10)
        for tick in ticks(*self.panel.y_range, 10):
            yield f'<path d="M{self.left} {self.y(tick):.1f}H{right}" stroke="#e4e4e4"/>'
            yield _text(self.left - 5, self.y(tick) + 4, f"{tick:g}", "end", 10)
        yield _text(self.left + self.width / 2, self.top - 10, self.panel.title, size=12)
        yield _text(self.left + self.width / 2, bottom + 33, self.panel.x_title)
        x, y = self.left - 42, self.top + self.height / 2
        yield _text(x, y, self.panel.y_title, more=f'transform="rotate(-90 {x:.1f} {y:.1f})"')

    def draw(self, series):
        low, high = self.panel.y_range
        places = [(self.x(x), self.y(y)) for x, y in series.points if low * 0.999 <= y <= high * 1.001]
        if series.line and places:
            dash = f' stroke-dasharray="{series.dash}"' if series.dash else ""
            path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
            yield f'<path d="{path}" fill="none" stroke="{series.color}" stroke-width="1.8"{dash}/>'
        if series.marker:
            yield from (_marker(series.marker, x, y, series.color) for x, y in places)


def _legend(series, left, top):
    for i, one in enumerate(series):
        x, y = left, top + 18 * i
        if one.line:
            dash = f' stroke-dasharray="{one.dash}"' if one.dash else ""
            yield f'<path d="M{x} {y}h28" stroke="{one.color}" stroke-width="1.8"{dash}/>'
        if one.marker:
            yield _marker(one.marker, x + 14, y, one.color)
        yield _text(x + 36, y + 4, one.title, "start", 10.5)


def svg(panels):
    """The panels side by side, and one legend of all their series below."""
    known = {one.title: one for panel in panels for one in panel.series}
    width, height = WIDTH * len(panels), HEIGHT + 24 + 18 * len(known)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">',
           f'<rect width="{width}" height="{height}" fill="#fff"/>']
    for i, panel in enumerate(panels):
        axes = _Axes(panel, WIDTH * i, 0)
        out += axes.grid()
        for series in panel.series:
            out += axes.draw(series)
    out += _legend(known.values(), LEFT, HEIGHT + 16)
    return "\n".join([*out, "</svg>"]) + "\n"
