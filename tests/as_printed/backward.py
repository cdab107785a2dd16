"""Backward mapping as printed (S5), affine and in perspective, floors and walls: float64, written from the description.

A row is walked by additions from its first sample on, a wall by columns. Compared row for row.
"""
import sys

import numpy as np

from comparison import arguments, compare, light_of, sample_text, scene_of
from faces import clipped, column_of, extent, face, inverse_of, numbers, row_of, spanning

WIDTH, HEIGHT = 48, 40


def affine_row(m, x, y, count):
    """(u, v) of a row. Q1: the loop adds before it samples."""
    u, v = m[0][0] * x + m[0][1] * y + m[0][2], m[1][0] * x + m[1][1] * y + m[1][2]
    for _ in range(count):
        u, v = u + m[0][0], v + m[1][0]
        yield u, v


def projective_row(m, x, y, count):
    """Two divisions a sample. Q1: v's numerator advances by b where it must by d."""
    U, V, W = (row[0] * x + row[1] * y + row[2] for row in m)
    for _ in range(count):
        yield U / W, V / W
        U, V, W = U + m[0][0], V + m[0][1], W + m[2][0]


def constant_row(m, x, y, count, along=0):
    """One division a row, or along 1 a column."""
    w = 1 / (m[2][0] * x + m[2][1] * y + m[2][2])
    u, v = ((row[0] * x + row[1] * y + row[2]) * w for row in m[:2])
    for _ in range(count):
        yield u, v
        u, v = u + m[0][along] * w, v + m[1][along] * w


def draw(scene, corners, perspective, walk, light, size, wrap):
    ring = numbers([c if perspective else c[:4] + [1] for c in corners])
    points = [(c[0], c[1]) for c in ring]
    base, area = spanning(ring)
    if area == 0:
        return []
    m = inverse_of(base)
    wall = walk is constant_row and abs(m[2][1]) < abs(m[2][0])
    out = []
    for line in clipped(extent([p[0 if wall else 1] for p in points]), WIDTH if wall else HEIGHT):
        if wall:
            along = clipped(column_of(points, line + 0.5), HEIGHT)
            uv = constant_row(m, line + 0.5, along.start + 0.5, len(along), 1)
        else:
            along = clipped(row_of(points, line + 0.5), WIDTH)
            uv = walk(m, along.start + 0.5, line + 0.5, len(along))
        for n, (u, v) in zip(along, uv):
            x, y = (line, n) if wall else (n, line)
            out.append(sample_text(scene, x, y, u, v, light, size, wrap))
    return out


METHODS = {"backward-affine": (False, affine_row), "backward-projective": (True, projective_row),
           "constant-z": (True, constant_row)}


def main():
    args, rng = arguments(__doc__, 500)
    np.seterr(all="ignore")  # W may be 0 beyond the spanning corners
    failed = False
    for method, (perspective, walk) in METHODS.items():
        scenes, expected = [], []
        for n in range(args.count):
            corners, light, wrap = face(rng), light_of(rng), rng.choice(["repeat", "mask", "clamp"])
            size = rng.choice([(32, 64), (64, 64), (256, 16)] + [(48, 10), (7, 300)] * (wrap != "mask"))
            scenes.append(scene_of(corners, light, size, wrap, WIDTH, HEIGHT))
            expected.append(draw(n, corners, perspective, walk, light, size, wrap))
        print(method, end=": ")
        failed |= compare(args.texelscope, ["--method", method, "--variant", "as-printed"], scenes, expected) > 0
    return failed


if __name__ == "__main__":
    sys.exit(main())
