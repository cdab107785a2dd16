"""Barycentric weights as printed (S4): float64 in NumPy, written from the description, compared row for row.

A polygon is a fan from its first corner, and every second triangle of it is edged in red, the others in green.
"""
import sys

import numpy as np

from comparison import address_texel, arguments, compare, light_of, lit, row_text, scene_of, single, whole
from edge_equations import triangle
from sections import polygon

WIDTH, HEIGHT = 48, 40
GREEN, RED = (0, 255, 0), (255, 0, 0)
EDGE = 0.05  # weights below it lie in the tinted edge


def area(a, b, c):
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2


def box(values, size):
    """The rows or columns from the least value to the greatest, inclusive, that lie in the picture."""
    return max(int(np.floor(min(values))), 0), min(int(np.floor(max(values))) + 1, size)


def samples(corners, width, height):
    """X, Y, u, v of what one triangle draws, and whether it lies in the edge. A corner is x, y, u, v, w."""
    p = [[np.float64(n) for n in corner] for corner in corners]
    whole_area = area(*p)
    (xa, xb), (ya, yb) = box([c[0] for c in p], width), box([c[1] for c in p], height)
    if whole_area == 0 or xa >= xb or ya >= yb:
        return [np.empty(0)] * 5
    Y, X = (a.astype(np.float64) for a in np.mgrid[ya:yb, xa:xb])
    e = [area(p[1], p[2], (X, Y)) / whole_area, area(p[2], p[0], (X, Y)) / whole_area,
         area(p[0], p[1], (X, Y)) / whole_area]
    inside = np.all([(0 <= weight) & (weight <= 1) for weight in e], axis=0)
    X, Y, e = X[inside], Y[inside], [weight[inside] for weight in e]
    q = [[component * (1 / c[4]) for component in (c[2], c[3], np.float64(1))] for c in p]
    l_u, l_v, l_1 = ((q[0][n] * e[0] + q[1][n] * e[1]) + q[2][n] * e[2] for n in range(3))
    return X, Y, l_u / l_1, l_v / l_1, np.min(e, axis=0) < EDGE


def tinted(colour, shape):
    return [c // 2 + tint // 2 for c, tint in zip(colour, RED if shape % 2 else GREEN)]


def draw(scene, corners, light, size):
    out = []
    for shape in range(len(corners) - 2):
        fan = corners[0], corners[shape + 1], corners[shape + 2]
        for x, y, u, v, edge in zip(*samples(fan, WIDTH, HEIGHT)):
            column, row = whole(u) & (size[0] - 1), whole(v) & (size[1] - 1)
            colour = lit(address_texel(column, row), light)
            out.append(row_text(scene, int(x), int(y), u, v, column, row, tinted(colour, shape) if edge else colour))
    return out


def main():
    args, rng = arguments(__doc__, 1000)
    scenes, expected = [], []
    for n in range(args.count):
        corners = triangle(rng) if rng.random() < 0.5 else polygon(rng)
        flat = rng.random() < 0.2
        corners = [c + [1.0 if flat else single(rng.uniform(0.2, 5))] for c in corners]
        light, size = light_of(rng), rng.choice([(32, 64), (64, 64), (256, 16), (1, 8)])
        scenes.append(scene_of(corners, light, size, rng.choice(["repeat", "mask", "clamp"]), WIDTH, HEIGHT))
        expected.append(draw(n, corners, light, size))
    return compare(args.texelscope, ["--method", "barycentric", "--variant", "as-printed"], scenes, expected) > 0


if __name__ == "__main__":
    sys.exit(main())
