"""How far a tool tip is from its path along a run, as SVG. Standard library only."""

import math

WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 860, 360, 60, 40, 34
COLOURS = ("#1f5fa8", "#c0392b", "#2e7d32")
PIECES = 800  # across the plot: the largest value of each is drawn


def thinned(rows):
    """(time, value) pairs, the largest value of each of PIECES equal parts of the time."""
    last = rows[-1][0]
    parts = {}
    for time, value in rows:
        part = min(PIECES - 1, int(PIECES * time / last))
        if part not in parts or value > parts[part][1]:
            parts[part] = (time, value)
    return [parts[part] for part in sorted(parts)]


def decades(values):
    """The powers of ten that enclose the values."""
    return math.floor(math.log10(max(min(values), 1e-2))), math.ceil(math.log10(max(values)))


def deviation_plot(title, curves):
    """SVG text: a curve for each (name, [(time in s, deviation in um), ...]), deviations on a logarithmic scale."""
    curves = [(name, thinned(rows)) for name, rows in curves]
    low, high = decades([value for _, rows in curves for _, value in rows])
    seconds = max(rows[-1][0] for _, rows in curves)
    wide, tall = WIDTH - LEFT - 20, HEIGHT - TOP - BOTTOM

    def x(time):
        return LEFT + wide * time / seconds

    def y(value):
        return TOP + tall * (high - math.log10(max(value, 10.0 ** low))) / (high - low)

    parts = [f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}' font-family='sans-serif' "
             "font-size='12' fill='none'>", f"<rect width='{WIDTH}' height='{HEIGHT}' fill='white'/>",
             f"<text x='{LEFT}' y='18' fill='black'>{title}</text>"]
    for decade in range(low, high + 1):
        at = y(10.0 ** decade)
        parts.append(f"<line x1='{LEFT}' y1='{at:.1f}' x2='{LEFT + wide}' y2='{at:.1f}' stroke='#ccc'/>"
                     f"<text x='{LEFT - 6}' y='{at + 4:.1f}' text-anchor='end' fill='#444'>{10.0 ** decade:g} um</text>")
    for time in range(0, int(seconds) + 1, 5):
        parts.append(f"<text x='{x(time):.1f}' y='{HEIGHT - 20}' text-anchor='middle' fill='#444'>{time} s</text>")
    for (name, rows), colour, place in zip(curves, COLOURS, range(3)):
        points = " ".join(f"{x(time):.1f},{y(value):.1f}" for time, value in rows)
        parts.append(f"<polyline points='{points}' stroke='{colour}'/>"
                     f"<text x='{LEFT + 240 * place}' y='{HEIGHT - 4}' fill='{colour}'>{name}</text>")
    return "\n".join(parts) + "\n</svg>\n"
