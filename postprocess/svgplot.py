"""Small line plots as inline SVG for the report: no image files, no fonts, the same bytes for the same data.

Not for the paper's figures (matplotlib, style.py): a report holds a hundred small overlays that must be written in a second.
"""

import math
from html import escape

COLOURS = ["#c0392b", "#2c6fbb", "#2e8b57", "#8e5ea2", "#d98e04", "#5f6b73", "#0f8b8d", "#a0522d", "#e0569b", "#6b8e23", "#1b2a6b"]
WIDTH, HEIGHT = 420, 270
LEFT, RIGHT, TOP, BOTTOM = 62, 12, 14, 40
LEGEND_LINE = 14


def finite(values):
    return [v for v in values if v is not None and math.isfinite(v)]


def nice_ticks(low, high, count=5):
    """Round numbers between low and high (linear axis)."""
    span = high - low
    raw = span / max(1, count)
    power = 10 ** math.floor(math.log10(raw))
    step = next(s * power for s in (1, 2, 2.5, 5, 10) if s * power >= raw * 0.999)
    first = math.ceil(low / step - 1e-9)
    ticks = []
    while first * step <= high + 1e-9 * span:
        ticks.append(first * step if abs(first * step) > 1e-12 * span else 0.0)
        first += 1
    return ticks


def log_ticks(low, high):
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    ticks = [m * 10.0**d for d in decades for m in (1, 2, 5) if low * 0.999 <= m * 10.0**d <= high * 1.001]
    if len(ticks) > 7:
        ticks = [10.0**d for d in decades if low * 0.999 <= 10.0**d <= high * 1.001]
    if len(ticks) < 2:  # less than a factor two: round numbers, as on a linear axis
        ticks = nice_ticks(low, high, 3)
    return ticks


def number(value):
    """A tick label, short."""
    if value == 0:
        return "0"
    text = f"{value:.3g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        text = f"{mantissa}e{int(exponent)}"
    return text


class Axis:
    """From data to pixels along one direction."""

    def __init__(self, values, start, end, log=False, pad=0.04):
        values = finite(values)
        if log:
            values = [v for v in values if v > 0]
        low, high = (min(values), max(values)) if values else (0.1 if log else 0.0, 1.0)
        if log:
            low, high = low / 1.25, high * 1.25
        elif high - low <= 1e-12 * max(abs(low), abs(high)):
            size = abs(high) or 1.0
            low, high = low - 0.5 * size, high + 0.5 * size
        else:
            low, high = low - pad * (high - low), high + pad * (high - low)
        self.low, self.high, self.start, self.end, self.log = low, high, start, end, log

    def position(self, value):
        if self.log:
            part = (math.log(value) - math.log(self.low)) / (math.log(self.high) - math.log(self.low))
        else:
            part = (value - self.low) / (self.high - self.low)
        return self.start + part * (self.end - self.start)

    def ticks(self):
        return log_ticks(self.low, self.high) if self.log else nice_ticks(self.low, self.high)


class Plot:
    """Collects lines and points, then draws them. Series are dicts with x, y and style."""

    def __init__(self, x_label="", y_label="", log_x=False, log_y=False, equal=False, size=(WIDTH, HEIGHT), legend_width=0):
        self.x_label, self.y_label = x_label, y_label
        self.log_x, self.log_y, self.equal = log_x, log_y, equal
        self.width, self.height = size
        self.right = self.width - (legend_width or RIGHT)
        self.beside = legend_width > 0  # a legend beside the frame, else above it: it never covers data
        self.top = TOP
        self.series = []

    def line(self, x, y, label="", colour=None, dash="", width=1.8, closed=False):
        self.series.append(
            dict(kind="line", x=x, y=y, label=label, colour=colour, dash=dash, width=width, closed=closed)
        )

    def points(self, x, y, label="", colour=None, pale=False, titles=None, shape="circle"):
        self.series.append(dict(kind="points", x=x, y=y, label=label, colour=colour, pale=pale, titles=titles, shape=shape))

    def _make_room(self):
        """The frame keeps its height; the legend's lines come on top of it."""
        lines = 0 if self.beside else sum(1 for s in self.series if s["label"])
        top = TOP + LEGEND_LINE * lines
        self.height, self.top = self.height + top - self.top, top

    def svg(self):
        self._make_room()
        xs = [v for s in self.series for v in s["x"]]
        ys = [v for s in self.series for v in s["y"]]
        x_axis = Axis(xs, LEFT, self.right, self.log_x)
        y_axis = Axis(ys, self.height - BOTTOM, self.top, self.log_y)
        if self.equal:
            self._make_equal(x_axis, y_axis)
        parts = [
            f'<svg viewBox="0 0 {self.width} {self.height}" width="{self.width}" height="{self.height}" '
            'role="img" font-family="sans-serif" font-size="11">'
        ]
        parts += self._frame(x_axis, y_axis)
        for k, series in enumerate(self.series):
            colour = series["colour"] or COLOURS[k % len(COLOURS)]
            draw = self._draw_line if series["kind"] == "line" else self._draw_points
            parts += draw(series, colour, x_axis, y_axis)
        parts += self._legend()
        parts.append("</svg>")
        return "".join(parts)

    @staticmethod
    def _make_equal(x_axis, y_axis):
        scale = max(
            (x_axis.high - x_axis.low) / abs(x_axis.end - x_axis.start),
            (y_axis.high - y_axis.low) / abs(y_axis.end - y_axis.start),
        )
        for axis in (x_axis, y_axis):
            middle, half = 0.5 * (axis.low + axis.high), 0.5 * scale * abs(axis.end - axis.start)
            axis.low, axis.high = middle - half, middle + half

    def _frame(self, x_axis, y_axis):
        top, bottom, right = self.top, self.height - BOTTOM, self.right
        parts = [
            f'<rect x="{LEFT}" y="{top}" width="{right - LEFT}" height="{bottom - top}" fill="none" stroke="currentColor" stroke-opacity=".35"/>'
        ]
        for tick in x_axis.ticks():
            x = x_axis.position(tick)
            parts.append(f'<path d="M{x:.1f} {bottom}v-{bottom - top}" stroke="currentColor" stroke-opacity=".08"/>')
            parts.append(f'<text x="{x:.1f}" y="{bottom + 14}" text-anchor="middle" fill="currentColor">{number(tick)}</text>')
        for tick in y_axis.ticks():
            y = y_axis.position(tick)
            parts.append(f'<path d="M{LEFT} {y:.1f}h{right - LEFT}" stroke="currentColor" stroke-opacity=".08"/>')
            parts.append(f'<text x="{LEFT - 5}" y="{y + 4:.1f}" text-anchor="end" fill="currentColor">{number(tick)}</text>')
        middle_x, middle_y = 0.5 * (LEFT + right), 0.5 * (top + bottom)
        parts.append(f'<text x="{middle_x}" y="{self.height - 8}" text-anchor="middle" fill="currentColor">{escape(self.x_label)}</text>')
        parts.append(
            f'<text transform="translate(13 {middle_y}) rotate(-90)" text-anchor="middle" fill="currentColor">{escape(self.y_label)}</text>'
        )
        return parts

    def _draw_line(self, series, colour, x_axis, y_axis):
        path, pen = [], False
        for x, y in zip(series["x"], series["y"]):
            good = x is not None and y is not None and math.isfinite(x) and math.isfinite(y)
            good = good and not (self.log_x and x <= 0) and not (self.log_y and y <= 0)
            if good:
                path.append(f"{'L' if pen else 'M'}{x_axis.position(x):.1f} {y_axis.position(y):.1f}")
            pen = good
        if series["closed"] and path:
            path.append("Z")
        dash = f' stroke-dasharray="{series["dash"]}"' if series["dash"] else ""
        return [f'<path d="{"".join(path)}" fill="none" stroke="{colour}" stroke-width="{series["width"]}"{dash}/>']

    def _draw_points(self, series, colour, x_axis, y_axis):
        parts = []
        opacity = ".28" if series["pale"] else "1"
        for k, (x, y) in enumerate(zip(series["x"], series["y"])):
            if x is None or y is None or not (math.isfinite(x) and math.isfinite(y)):
                continue
            px, py = x_axis.position(x), y_axis.position(y)
            title = f"<title>{escape(series['titles'][k])}</title>" if series["titles"] else ""
            if series["shape"] == "cross":
                mark = f'<path d="M{px - 4:.1f} {py - 4:.1f}l8 8m0 -8l-8 8" stroke="{colour}" stroke-width="1.6" stroke-opacity="{opacity}">{title}</path>'
            else:
                mark = f'<circle cx="{px:.1f}" cy="{py:.1f}" r="4" fill="{colour}" fill-opacity="{opacity}">{title}</circle>'
            parts.append(mark)
        return parts

    def _legend(self):
        parts, y, x = [], self.top + 13 if self.beside else TOP - 2, self.right + 8 if self.beside else 12
        for k, series in enumerate(self.series):
            if not series["label"]:
                continue
            colour = series["colour"] or COLOURS[k % len(COLOURS)]
            dash = f' stroke-dasharray="{series.get("dash")}"' if series.get("dash") else ""
            parts.append(f'<path d="M{x} {y - 4}h18" stroke="{colour}" stroke-width="3"{dash}/>')
            parts.append(f'<text x="{x + 23}" y="{y}" fill="currentColor">{escape(series["label"])}</text>')
            y += LEGEND_LINE
        return parts


def standalone(svg):
    """An SVG element as a file of its own: named space, white paper, black ink."""
    head, rest = svg.split(">", 1)
    head = head.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" color="#1d2226" ', 1)
    return f'{head}><rect width="100%" height="100%" fill="#ffffff"/>{rest}\n'
