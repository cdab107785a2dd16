"""Which methods must agree, and do: corrected, with exact numbers, on shapes where they define one and the same thing.

Compared are the pixels drawn, and for each its texel and the very u and v.
"""
import argparse
import json
import random
import sys

from shapes import HEIGHT, WIDTH, affine_polygon, any_triangle, floor, parallelogram, plane, rectangle, wall
from comparison import rows_drawn, scene_of  # found by the path that shapes.py sets

TEXELS, PIXELS = "texels", "pixels"
TRIANGLES = ["edge-equations", "edge-walk", "barycentric", "sections"]
EQUALITIES = [  # the same what, on which shapes, by which methods
    (TEXELS, any_triangle, TRIANGLES),
    (TEXELS, affine_polygon, TRIANGLES),
    (TEXELS, parallelogram, ["edge-equations", "backward-affine"]),
    (TEXELS, rectangle, ["edge-equations", "sampling-1d"]),
    (TEXELS, plane, ["barycentric", "backward-projective"]),
    (TEXELS, floor, ["backward-projective", "constant-z", "barycentric"]),
    (TEXELS, wall, ["backward-projective", "constant-z", "barycentric"]),
    (PIXELS, plane, ["backward-projective", "two-pass"]),
    (PIXELS, affine_polygon, ["backward-projective", "two-pass"]),
]


def kept(rows, what):
    """Sorted, as methods draw in different orders: pixel, and texel with the exact u and v."""
    fields = (row.split(",")[2:8] for row in rows)
    return sorted(fields if what == TEXELS else (f[:2] for f in fields))


def without_lost_columns(rows, two_pass):
    """Where a column of the picture runs along one row of the texture, the first pass has nothing to tell its pixels
    apart by: two passes lose it. All its samples have the same v then."""
    columns = {}
    for row in rows:
        columns.setdefault(row.split(",")[2], []).append(row)
    left = {row.split(",")[2] for row in two_pass}
    return [row for x, column in columns.items() for row in column
            if x in left or len({r.split(",")[5] for r in column}) > 1]


def report(what, shape, scenes, methods, drawn):
    """Prints one line, and the first differences. Returns how many scenes differ."""
    bad = [n for n in range(len(scenes)) if drawn[0][n] != drawn[1][n]]
    samples = sum(map(len, drawn[0]))
    print(f"{' = '.join(methods):38}{what:8}{shape:16}{samples:8} samples {len(bad):5} scenes differ")
    for n in bad[:2]:
        print(f"  {json.dumps(scenes[n])}")
        for method, mine, other in (methods[0], *drawn), (methods[1], *drawn[::-1]):
            print(f"  only {method}: {[sample for sample in mine[n] if sample not in other[n]][:3]}")
    return len(bad)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--texelscope", required=True)
    parser.add_argument("--seed", type=int, default=1995)
    parser.add_argument("--count", type=int, default=1000, help="scenes for each equality")
    args = parser.parse_args()
    print(f"seed {args.seed}, {args.count} scenes each")
    rng, differing = random.Random(args.seed), 0
    for what, shape, methods in EQUALITIES:
        size, wrap = rng.choice([(32, 16), (64, 64), (24, 10)]), rng.choice(["repeat", "clamp"])
        scenes = [scene_of(shape(rng), 1, size, wrap, WIDTH, HEIGHT) for _ in range(args.count)]
        rows = []
        for method in methods:
            options = ["--method", method, "--variant", "corrected", "--number", "exact"]
            rows.append(rows_drawn(args.texelscope, options, scenes))
        if methods[-1] == "two-pass":
            rows[0] = [without_lost_columns(a, b) for a, b in zip(*rows)]
        drawn = [[kept(scene, what) for scene in of_method] for of_method in rows]
        for n in range(1, len(methods)):
            pair = [methods[0], methods[n]], [drawn[0], drawn[n]]
            differing += report(what, shape.__name__, scenes, *pair)
    return differing > 0


if __name__ == "__main__":
    sys.exit(main())
