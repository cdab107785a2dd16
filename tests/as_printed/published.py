"""Edge equations as published (S1, the speaker's own program): what its NumPy computes, compared row for row.

Samples lie in the middle of pixels. The set-up is in double; the arrays hold float32, and NumPy rounds each number
that it meets them with to float32, so that every product and sum of a pixel is one of float32.
"""
import sys

import numpy as np

from comparison import address_texel, arguments, compare, light_of, row_text, scene_of
from edge_equations import HEIGHT, WIDTH, plane, triangle

X, Y = (a.astype(np.float32) for a in np.meshgrid(np.arange(WIDTH) + 0.5, np.arange(HEIGHT) + 0.5))


def affine(x, y, a_x, a_y, a_k):
    """(x a_x + y a_y) + a_k in float32."""
    a_x, a_y, a_k = (np.float32(a) for a in (a_x, a_y, a_k))
    return x * a_x + y * a_y + a_k


def draw(scene, corners, light, size):
    p = [tuple(np.float64(n) for n in c) for c in corners]
    (x0, y0), (x1, y1), (x2, y2) = ((c[0], c[1]) for c in p)
    delta = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    if delta == 0:
        return []
    xs, ys = [c[0] for c in p], [c[1] for c in p]
    xa, xb = max(0, int(np.trunc(min(xs)))), min(WIDTH, int(np.trunc(max(xs))) + 1)
    ya, yb = max(0, int(np.trunc(min(ys)))), min(HEIGHT, int(np.trunc(max(ys))) + 1)
    if xa >= xb or ya >= yb:
        return []
    x, y = X[ya:yb, xa:xb], Y[ya:yb, xa:xb]
    mask = np.ones(x.shape, dtype=bool)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        n_x, n_y = p[j][1] - p[i][1], p[i][0] - p[j][0]
        mask &= affine(x, y, n_x, n_y, -(p[i][0] * n_x + p[i][1] * n_y)) <= 0
    x, y = x[mask], y[mask]
    u = affine(x, y, *plane(p, [c[2] for c in p], delta))
    v = affine(x, y, *plane(p, [c[3] for c in p], delta))
    assert u.dtype == v.dtype == np.float32
    columns, rows = np.trunc(u).astype(np.int64) & (size[0] - 1), np.trunc(v).astype(np.int64) & (size[1] - 1)
    out = []
    for n in range(len(x)):
        texel = address_texel(int(columns[n]), int(rows[n]))
        colour = [int(np.trunc(np.float64(c) * np.float64(light))) % 256 for c in texel]
        at = int(x[n]), int(y[n])
        out.append(row_text(scene, *at, np.float64(u[n]), np.float64(v[n]), columns[n], rows[n], colour))
    return out


def main():
    args, rng = arguments(__doc__, 1000)
    scenes, expected = [], []
    for n in range(args.count):
        corners, light = triangle(rng), light_of(rng)
        size = rng.choice([(32, 64), (64, 64), (256, 16), (1, 8), (512, 256)])
        scenes.append(scene_of(corners, light, size, rng.choice(["repeat", "mask"]), WIDTH, HEIGHT))
        expected.append(draw(n, corners, light, size))
    return compare(args.texelscope, ["--method", "edge-equations", "--variant", "as-published"], scenes, expected) > 0


if __name__ == "__main__":
    sys.exit(main())
