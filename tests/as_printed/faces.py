"""Convex faces and how their texture lies (S5), shared by backward.py, forward.py and sampling_1d.py: float64.

The texture is laid on by three corners, those of the widest triangle of a fan from the first. (u, v, 1)/W is the
inverse of their columns (x w, y w, w), by cofactors.
"""
import numpy as np

from comparison import single
from edge_equations import triangle
from sections import polygon


def face(rng):
    """A convex face, each corner x, y, u, v, w: mostly in perspective, some of them no plane at all."""
    kind = rng.choice(["triangle", "bent", "parallelogram", "plane", "plane", "floor", "wall"])
    if kind == "triangle":
        return [corner + [single(rng.uniform(0.2, 5))] for corner in triangle(rng)]
    ring = polygon(rng)
    if kind == "bent":
        return [corner + [single(rng.uniform(0.5, 2))] for corner in ring]
    if kind == "parallelogram":
        a, b, c = (corner[:4] for corner in ring[:3])
        return [corner + [1.0] for corner in (a, b, [single(q + r - p) for p, q, r in zip(a, b, c)], c)]
    a, b, d, e, g, h = (rng.uniform(-2, 2) for _ in range(6))
    g, h = (0 if kind == "floor" else g), (0 if kind == "wall" else h)
    least = min(g * x + h * y for x, y, _, _ in ring)
    out = []
    for x, y, _, _ in ring:
        w = 1 / (g * x + h * y - least + 2)
        out.append([x, y] + [single(n) for n in ((a * x + b * y) * w, (d * x + e * y) * w, w)])
    return out


def spanning(ring):
    """The three corners that say how the texture lies, and twice their area."""
    def doubled(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    fan = [(ring[0], ring[n - 1], ring[n]) for n in range(2, len(ring))]
    widest = max(fan, key=lambda corners: abs(doubled(*corners)))
    return widest, doubled(*widest)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def over_columns(rows, columns):
    """rows · C⁻¹, where C has the columns."""
    def cofactors(a, b):
        return [a[(m + 1) % 3] * b[(m + 2) % 3] - a[(m + 2) % 3] * b[(m + 1) % 3] for m in range(3)]
    inverse = [cofactors(columns[(n + 1) % 3], columns[(n + 2) % 3]) for n in range(3)]
    det = dot(columns[0], inverse[0])
    return [[dot(row, [line[m] for line in inverse]) / det for m in range(3)] for row in rows]


def on_screen(corners):
    """The columns (x w, y w, w)."""
    return [(x * w, y * w, w) for x, y, _, _, w in corners]


def inverse_of(corners):
    """(a b c), (d e f), (g h i)."""
    one = np.float64(1)
    return over_columns([[c[2] for c in corners], [c[3] for c in corners], [one] * 3], on_screen(corners))


def crossings(points, across):
    """Where the line y = across meets the sides of a ring, each followed from its end of the lesser y; and whether
    x grows with y there."""
    for p, q in zip(points, points[1:] + points[:1]):
        first, last = (q, p) if q[1] < p[1] else (p, q)
        if first[1] <= across < last[1]:
            t = (across - first[1]) / (last[1] - first[1])
            yield first[0] + t * (last[0] - first[0]), first[0] < last[0]


def first_at(a):
    """The first index whose sample is at `a` or behind it."""
    return int(np.ceil(a - 0.5))


def extent(values):
    """The indices of the samples from the least value up to but without the greatest."""
    return range(first_at(min(values)), first_at(max(values)))


def row_of(points, y):
    """From the left crossing up to but without the right one."""
    return extent([x for x, _ in crossings(points, y)] or [0])


def column_of(points, x):
    """The same samples found by columns: one that lies on a side is inside if that is a top side or a left one."""
    met = list(crossings([(p[1], p[0]) for p in points], x))
    if not met:
        return range(0)
    top, bottom = min(met)[0], max(met)[0]
    owns_top = any(y == top and not falls for y, falls in met)
    owns_bottom = any(y == bottom and falls for y, falls in met)
    first = first_at(top) if owns_top else int(np.floor(top - 0.5)) + 1
    return range(first, int(np.floor(bottom - 0.5)) + 1 if owns_bottom else first_at(bottom))


def clipped(indices, size):
    return range(max(indices.start, 0), min(indices.stop, size))


def numbers(corners):
    """The corners as NumPy's numbers, which divide by zero as the processor does."""
    return [tuple(np.float64(n) for n in corner) for corner in corners]
