"""Forward mapping and two passes as printed (S5): float64, written from the description, compared row for row.

The texture drives: each texel, from its middle, goes to the pixel that it falls on. In two passes it first goes to a
column of its own row, tmp[x][v] = u, the last one to come there staying; then what stands in a column goes to its row.
"""
import sys

import numpy as np

from comparison import arguments, below, compare, light_of, sample_text, scene_of
from faces import extent, face, numbers, on_screen, over_columns, row_of, spanning

WIDTH, HEIGHT = 48, 40


def map_of(base):
    """(x w, y w, w) = M (u, v, 1)."""
    columns = on_screen(base)
    rows = [[column[k] for column in columns] for k in range(3)]
    return over_columns(rows, [(u, v, np.float64(1)) for _, _, u, v, _ in base])


def mapped(m, k, u, v):
    """x for k = 0, y for k = 1."""
    w = m[2][0] * u + m[2][1] * v + m[2][2]
    return (m[k][0] * u + m[k][1] * v + m[k][2]) / w


def texels_of(points):
    """The texels whose middles lie on the face: v and the range of u, row by row."""
    for v in extent([p[1] for p in points]):
        yield v, row_of(points, np.float64(v) + 0.5)


def forward(m, ring):
    """Which (u, v) each pixel gets, one after the other."""
    for v, us in texels_of([(c[2], c[3]) for c in ring]):
        v_c = np.float64(v) + 0.5
        for u in us:
            u_c = np.float64(u) + 0.5
            yield mapped(m, 0, u_c, v_c), mapped(m, 1, u_c, v_c), u_c, v_c


def two_passes(m, ring):
    tmp = {}
    for v, us in texels_of([(c[2], c[3]) for c in ring]):
        for u in us:
            x = mapped(m, 0, np.float64(u) + 0.5, np.float64(v) + 0.5)
            if np.isfinite(x):
                tmp[below(x), v] = u
    # Only columns that the face reaches have a place in the buffer.
    columns = range(below(min(c[0] for c in ring)), int(np.ceil(max(c[0] for c in ring))))
    for x, v in sorted(tmp):
        if x in columns:
            x_c, v_c = np.float64(x) + 0.5, np.float64(v) + 0.5
            # Where on its row does the column lie? Solved for u: (m11 u + m12 v + m13) / (m31 u + m32 v + m33) = x.
            u = ((m[2][1] * v_c + m[2][2]) * x_c - m[0][1] * v_c - m[0][2]) / (m[0][0] - m[2][0] * x_c)
            yield x_c, mapped(m, 1, u, v_c), np.float64(tmp[x, v]) + 0.5, v_c


def draw(scene, corners, method, light, size, wrap):
    ring = numbers(corners)
    base, area = spanning(ring)
    if area == 0 or spanning([(u, v) for _, _, u, v, _ in base])[1] == 0:
        return []
    out = []
    for x, y, u, v in method(map_of(base), ring):
        if np.isfinite(x) and np.isfinite(y) and below(x) in range(WIDTH) and below(y) in range(HEIGHT):
            out.append(sample_text(scene, below(x), below(y), u, v, light, size, wrap))
    return out


def main():
    args, rng = arguments(__doc__, 300)
    np.seterr(all="ignore")  # a column may meet its row nowhere
    failed = False
    for name, method in {"forward": forward, "two-pass": two_passes}.items():
        scenes, expected = [], []
        for n in range(args.count):
            corners, light, wrap = face(rng), light_of(rng), rng.choice(["repeat", "mask", "clamp"])
            if rng.random() < 0.4:  # then texels' middles often fall right between pixels
                corners = [[float(round(number)) for number in corner[:4]] + [1.0] for corner in corners]
            size = rng.choice([(32, 64), (64, 64), (256, 16)] + [(48, 10), (7, 300)] * (wrap != "mask"))
            scenes.append(scene_of(corners, light, size, wrap, WIDTH, HEIGHT))
            expected.append(draw(n, corners, method, light, size, wrap))
        print(name, end=": ")
        failed |= compare(args.texelscope, ["--method", name, "--variant", "as-printed"], scenes, expected) > 0
    return failed


if __name__ == "__main__":
    sys.exit(main())
