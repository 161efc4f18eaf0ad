"""Polar plots of circular tests as SVG: deviations from the circle, magnified. Standard library only."""

import math

SIZE = 420
MIDDLE = SIZE / 2
RADIUS = 130  # of the circle itself, px
STYLES = ("stroke='#1f5fa8' stroke-width='1.6'", "stroke='#c0392b' stroke-width='1.4' stroke-dasharray='5 3'")


def centred(angles_deg, radial_um):
    """The profile without what set-up explains: mean and first harmonic."""
    count = len(radial_um)
    turns = [math.radians(a) for a in angles_deg]
    mean = sum(radial_um) / count
    cosine = 2 / count * sum(r * math.cos(t) for r, t in zip(radial_um, turns))
    sine = 2 / count * sum(r * math.sin(t) for r, t in zip(radial_um, turns))
    return [r - mean - cosine * math.cos(t) - sine * math.sin(t) for r, t in zip(radial_um, turns)]


def nice_step(largest):
    """The step of the rings: the largest deviation fills a few of them."""
    power = 10 ** math.floor(math.log10(max(largest, 1e-3)))
    return next(power * k for k in (0.2, 0.5, 1, 2, 5, 10) if power * k * 4 >= largest)


def polar_plot(title, profiles):
    """SVG text of up to two profiles (name, angles in deg, deviations in um) about one circle."""
    largest = max(abs(r) for _, _, radial in profiles for r in radial)
    step = nice_step(largest)
    scale = 18 / step  # px per um
    parts = [f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {SIZE} {SIZE + 60}' font-family='sans-serif' "
             "font-size='12' fill='none'>", f"<rect width='{SIZE}' height='{SIZE + 60}' fill='white'/>",
             f"<text x='{MIDDLE}' y='18' text-anchor='middle' fill='black'>{title}</text>"]
    for ring in range(-4, 5):
        stroke = "#888" if ring == 0 else "#ddd"
        parts.append(f"<circle cx='{MIDDLE}' cy='{MIDDLE + 20}' r='{RADIUS + 18 * ring}' stroke='{stroke}'/>")
    for axis, (x, y) in (("X", (SIZE - 8, MIDDLE + 24)), ("Y", (MIDDLE - 4, 32))):
        parts.append(f"<text x='{x}' y='{y}' fill='#666'>{axis}</text>")
    for (name, angles, radial), style, row in zip(profiles, STYLES, (0, 1)):
        points = " ".join(
            f"{MIDDLE + (RADIUS + scale * r) * math.cos(math.radians(a)):.1f},"
            f"{MIDDLE + 20 - (RADIUS + scale * r) * math.sin(math.radians(a)):.1f}" for a, r in zip(angles, radial))
        parts.append(f"<polygon points='{points}' {style}/>")
        y = SIZE + 28 + 18 * row
        parts.append(f"<line x1='20' y1='{y - 4}' x2='50' y2='{y - 4}' {style}/>"
                     f"<text x='58' y='{y}' fill='black'>{name}: {max(radial) - min(radial):.1f} um</text>")
    parts.append(f"<text x='{SIZE - 20}' y='{SIZE + 28}' text-anchor='end' fill='black'>{step:g} um a ring</text></svg>")
    return "\n".join(parts) + "\n"
