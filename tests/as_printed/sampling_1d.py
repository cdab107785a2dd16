"""Sampling in one dimension as printed (S3): the two published lists, then random rectangles, row for row.

Pixel n takes the texel at start + n · ratio, where ratio = source size / destination size in two decimals. The list
that shrinks starts at 0, the one that grows at one ratio.
"""
import sys

import numpy as np

from comparison import arguments, compare, light_of, rows_drawn, sample_text, scene_of, single
from faces import clipped, extent, numbers, row_of
from sections import polygon

WIDTH, HEIGHT = 48, 40
OPTIONS = ["--method", "sampling-1d", "--variant", "as-printed"]
PUBLISHED = {(8, 4): [0, 2, 4, 6], (8, 14): [0, 1, 1, 2, 2, 3, 3, 4, 5, 5, 6, 6, 7, 7]}


def rectangle(left, top, right, bottom, u0, v0, u1, v1):
    return [[left, top, u0, v0], [right, top, u1, v0], [right, bottom, u1, v1], [left, bottom, u0, v1]]


def shape(rng):
    """An upright rectangle, its texture either way up, its corners in either direction; at times another polygon."""
    if rng.random() < 0.1:
        return polygon(rng)
    whole = rng.random() < 0.4
    def number(least, most):
        return float(rng.randint(least, most)) if whole else single(rng.uniform(least, most))
    x, y = sorted(number(-8, WIDTH + 8) for _ in range(2)), sorted(number(-8, HEIGHT + 8) for _ in range(2))
    u, v = [number(-40, 80) for _ in range(2)], [number(-40, 80) for _ in range(2)]
    corners = rectangle(x[0], y[0], x[1], y[1], u[0], v[0], u[1], v[1])
    if rng.random() < 0.5:
        corners.reverse()
    start = rng.randrange(4)
    return corners[start:] + corners[:start]


def degenerate(ring):
    """Whether all triangles of the fan are without area."""
    (x0, y0), rest = ring[0][:2], ring[1:]
    return all((p[0] - x0) * (q[1] - y0) == (q[0] - x0) * (p[1] - y0) for p, q in zip(rest, rest[1:]))


def draw(scene, corners, light, size, wrap):
    ring = numbers(corners)
    if degenerate(ring):
        return []
    points = [(c[0], c[1]) for c in ring]
    left, right = min(ring, key=lambda c: c[0]), max(ring, key=lambda c: c[0])
    top, bottom = min(ring, key=lambda c: c[1]), max(ring, key=lambda c: c[1])
    ratio = np.rint((right[2] - left[2]) / (right[0] - left[0]) * 100) / 100
    start = left[2] + (ratio if abs(ratio) < 1 else 0)
    v_ratio = (bottom[3] - top[3]) / (bottom[1] - top[1])
    begin = extent([left[0]]).start
    out = []
    for y in clipped(extent([c[1] for c in ring]), HEIGHT):
        v = top[3] + (np.float64(y) + 0.5 - top[1]) * v_ratio
        for x in clipped(row_of(points, np.float64(y) + 0.5), WIDTH):
            out.append(sample_text(scene, x, y, start + np.float64(x - begin) * ratio, v, light, size, wrap))
    return out


def published(program):
    """Prints the source's own lists as the program picks them. Returns how many differ."""
    wrong = 0
    for (source, destination), expected in PUBLISHED.items():
        corners = rectangle(0, 0, destination, 1, 0, 0, source, 1)
        rows = rows_drawn(program, OPTIONS, [scene_of(corners, 1, (8, 1), "clamp", WIDTH, 1)])[0]
        picked = [int(row.split(",")[6]) for row in rows]
        print(f"{source} to {destination}:", *picked, "" if picked == expected else f"but published is {expected}")
        wrong += picked != expected
    return wrong


def main():
    args, rng = arguments(__doc__, 500)
    wrong = published(args.texelscope)
    scenes, expected = [], []
    for n in range(args.count):
        corners, light, wrap = shape(rng), light_of(rng), rng.choice(["repeat", "mask", "clamp"])
        size = rng.choice([(32, 64), (64, 64), (256, 16)] + [(48, 10), (7, 300)] * (wrap != "mask"))
        scenes.append(scene_of(corners, light, size, wrap, WIDTH, HEIGHT))
        expected.append(draw(n, corners, light, size, wrap))
    return compare(args.texelscope, OPTIONS, scenes, expected) + wrong > 0


if __name__ == "__main__":
    sys.exit(main())
