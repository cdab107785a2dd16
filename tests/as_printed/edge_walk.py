"""Walking the edges as printed (S3): float64 in NumPy, written from the description, compared row for row.

The long side is cut at the middle corner's height; both halves start at the whole row and pixel that holds the corner
or the side, and all advances by additions. What lies left of the picture or above it is skipped by one product.
"""
import sys

import numpy as np

from comparison import address_texel, arguments, compare, light_of, lit, row_text, scene_of, whole
from edge_equations import triangle

WIDTH, HEIGHT = 48, 40


def middle(p):
    """The corners from top to bottom, those of one height in the order of three exchanges of neighbours."""
    p = list(p)
    for n in (0, 1, 0):
        if p[n + 1][1] < p[n][1]:
            p[n], p[n + 1] = p[n + 1], p[n]
    return p


class Side:
    """From a corner down to another: x, u and v at a row, and what each row adds."""

    def __init__(self, upper, lower, row):
        height = lower[1] - upper[1]
        self.step = [(lower[n] - upper[n]) / height for n in (0, 2, 3)]
        ahead = np.float64(row - whole(upper[1]))
        self.at = [upper[n] + s * ahead for n, s in zip((0, 2, 3), self.step)]

    def advance(self):
        self.at = [a + s for a, s in zip(self.at, self.step)]


def half(scene, long, short, rows, size, light, out):
    if rows[0] >= rows[1]:
        return
    a, b = Side(*long, rows[0]), Side(*short, rows[0])
    for y in range(*rows):
        left, right = (b.at, a.at) if b.at[0] < a.at[0] else (a.at, b.at)
        begin = whole(left[0])
        first, last = max(begin, 0), min(whole(right[0]) + 1, WIDTH)
        if first < last:
            dx = right[0] - left[0]
            du, dv = (left[1] - right[1]) / dx, (left[2] - right[2]) / dx
            ahead = np.float64(first - begin)
            u, v = left[1] + du * ahead, left[2] + dv * ahead
            for x in range(first, last):
                column, row = whole(v) & (size[0] - 1), whole(u) & (size[1] - 1)
                out.append(row_text(scene, x, y, u, v, column, row, lit(address_texel(column, row), light)))
                u, v = u + du, v + dv
        a.advance()
        b.advance()


def draw(scene, p, light, size):
    p = [[np.float64(n) for n in corner] for corner in p]
    if (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]) == 0:
        return []
    p = middle(p)
    t = (p[1][1] - p[0][1]) / (p[2][1] - p[0][1])
    cut = [p[0][n] + t * (p[2][n] - p[0][n]) for n in range(4)]
    cut[1] = p[1][1]
    out = []
    tops = [max(whole(corner[1]), 0) for corner in p]
    ends = [min(whole(corner[1]) + 1, HEIGHT) for corner in p]
    if p[0][1] < p[1][1]:
        half(scene, (p[0], cut), (p[0], p[1]), (tops[0], ends[1]), size, light, out)
    if p[1][1] < p[2][1]:
        half(scene, (cut, p[2]), (p[1], p[2]), (tops[1], ends[2]), size, light, out)
    return out


def main():
    args, rng = arguments(__doc__, 1000)
    scenes, expected = [], []
    np.seterr(all="ignore")  # 0/0 at the apex is what the source does
    for n in range(args.count):
        p = triangle(rng)
        light = light_of(rng)
        size = rng.choice([(64, 64), (64, 64), (32, 32), (128, 16)])
        scenes.append(scene_of(p, light, size, rng.choice(["repeat", "mask"]), WIDTH, HEIGHT))
        expected.append(draw(n, p, light, size))
    return compare(args.texelscope, ["--method", "edge-walk", "--variant", "as-printed"], scenes, expected) > 0


if __name__ == "__main__":
    sys.exit(main())
