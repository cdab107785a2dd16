"""Random shapes on which several methods define one and the same thing, in numbers that float32 holds exactly.

Corners are in quarters of a pixel, so that samples often lie right on sides and corners. In perspective 1/w is
whole-numbered and affine over the screen, a power of two at the corners: so w, u and v there are exact.
"""
import pathlib
import sys

import numpy as np

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / "as_printed"), str(TESTS / "meshes")]
from comparison import single  # noqa: E402
from watertight import cross, hull  # noqa: E402

UNIT = 4  # corners are in whole numbers of them to a pixel
WIDTH, HEIGHT = 20, 16
GRID = np.meshgrid(np.arange(-UNIT, (WIDTH + 1) * UNIT), np.arange(-UNIT, (HEIGHT + 1) * UNIT))
POWERS = [1, 2, 4, 8, 16, 32, 64]


def place(rng):
    """In units. Every second one is a sample: an odd number of half pixels each way."""
    x, y = rng.randrange(-UNIT, (WIDTH + 1) * UNIT), rng.randrange(-UNIT, (HEIGHT + 1) * UNIT)
    return (x // 4 * 4 + 2, y // 4 * 4 + 2) if rng.random() < 0.5 else (x, y)


def outline(rng, corners):
    """A convex ring of so many corners, from any of them on, either way round."""
    ring = []
    while len(ring) != corners:
        ring = hull([place(rng) for _ in range(corners)])
    start = rng.randrange(corners)
    return (ring[start:] + ring[:start])[:: rng.choice([1, -1])]


def laid_on(rng, ring, upright=False):
    """u and v, affine over the screen, in 64ths of a texel; one to one, so that there is a way back."""
    a = b = d = e = 0
    while a * e == b * d:
        a, b, d, e = (rng.randint(-40, 40) for _ in range(4))
        b, d = (0, 0) if upright else (b, d)
    c, f = rng.randint(-99, 99), rng.randint(-99, 99)
    return [(x / UNIT, y / UNIT, (a * x + b * y + c) / 64, (d * x + e * y + f) / 64) for x, y in ring]


def any_triangle(rng):
    """Any u and v at all: three corners define one affine mapping."""
    return [(x / UNIT, y / UNIT, single(rng.uniform(-40, 40)), single(rng.uniform(-40, 40)))
            for x, y in outline(rng, 3)]


def affine_polygon(rng):
    return laid_on(rng, outline(rng, rng.randint(4, 7)))


def parallelogram(rng):
    while True:
        a, b, c = (place(rng) for _ in range(3))
        if cross(a, b, c) != 0:
            return laid_on(rng, [a, b, (b[0] + c[0] - a[0], b[1] + c[1] - a[1]), c])


def rectangle(rng):
    while True:
        (x0, y0), (x1, y1) = place(rng), place(rng)
        if x0 != x1 and y0 != y1:
            return laid_on(rng, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], upright=True)


def quad(rng, across, down):
    """(u, v, 1)/w = A (x, y, 1), whole numbers in A. 1/w = g x + h y + i: |g| at most `across`, |h| at most `down`."""
    while True:
        (a, b, c), (d, e, f) = ([rng.randint(-9, 9), rng.randint(-9, 9), rng.randint(-99, 99)] for _ in range(2))
        g, h, i = rng.randint(-across, across), rng.randint(-down, down), rng.randint(1, 40)
        if a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) == 0:
            continue
        over = g * GRID[0] + h * GRID[1] + i
        places = [(int(x), int(y)) for y, x in np.argwhere(np.isin(over, POWERS)) - UNIT]
        ring = hull([rng.choice(places) for _ in range(8)]) if places else []
        if len(ring) < 4:
            continue
        ring = [ring[n] for n in sorted(rng.sample(range(len(ring)), 4))]
        ring = ring[:: rng.choice([1, -1])]
        ones = [g * x + h * y + i for x, y in ring]
        if len(set(ones)) > 1:
            return [(x / UNIT, y / UNIT, (a * x + b * y + c) / one, (d * x + e * y + f) / one, 1 / one)
                    for (x, y), one in zip(ring, ones)]


def plane(rng):
    return quad(rng, 3, 3)


def floor(rng):
    return quad(rng, 0, 3)


def wall(rng):
    return quad(rng, 3, 0)
