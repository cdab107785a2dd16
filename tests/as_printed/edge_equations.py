"""Edge equations as printed (S1): float64 in NumPy, written from the description, compared row for row."""
import sys

import numpy as np

from comparison import address_texel, arguments, compare, light_of, row_text, scene_of, single

WIDTH, HEIGHT = 48, 40


def corner(rng, kind):
    if kind == "off_screen":
        x, y = rng.uniform(-200, 250), rng.uniform(-200, 250)
    elif kind == "far":
        x, y = rng.uniform(-5000, 5000), rng.uniform(-5000, 5000)
    elif kind == "integer":
        x, y = rng.randint(-8, WIDTH + 8), rng.randint(-8, HEIGHT + 8)
    elif kind == "quarter":
        x, y = rng.randint(-32, 4 * WIDTH + 32) / 4, rng.randint(-32, 4 * HEIGHT + 32) / 4
    else:
        x, y = rng.uniform(-4, WIDTH + 4), rng.uniform(-4, HEIGHT + 4)
    u, v = rng.uniform(-40, 80), rng.uniform(-40, 80)
    if rng.random() < 0.3:
        u, v = round(u), round(v)
    return [single(x), single(y), single(u), single(v)]


def triangle(rng):
    kind = rng.choice(["plain", "off_screen", "far", "integer", "quarter", "sliver", "aligned"])
    p = [corner(rng, "integer" if kind == "aligned" else kind) for _ in range(3)]
    if kind == "sliver":
        t, nudge = rng.random(), rng.choice([1e-4, 1e-2, 0.3])
        for axis in (0, 1):
            p[2][axis] = single(p[0][axis] + t * (p[1][axis] - p[0][axis]) + rng.uniform(-nudge, nudge))
    if kind == "aligned":
        for axis in (0, 1):
            p[2][axis] = 2 * p[1][axis] - p[0][axis]
    if rng.random() < 0.7:  # mostly the winding that is drawn
        (x0, y0), (x1, y1), (x2, y2) = ((c[0], c[1]) for c in p)
        if (x1 - x0) * (y2 - y0) < (x2 - x0) * (y1 - y0):
            p.reverse()
    return p


def plane(p, a, delta):
    (x0, y0), (x1, y1), (x2, y2) = ((c[0], c[1]) for c in p)
    a0, a1, a2 = a
    a_x = ((a1 - a0) * (y2 - y0) - (a2 - a0) * (y1 - y0)) / delta
    a_y = ((x1 - x0) * (a2 - a0) - (x2 - x0) * (a1 - a0)) / delta
    return a_x, a_y, a0 - x0 * a_x - y0 * a_y


def draw(scene, p, light, size):
    p = [tuple(np.float64(n) for n in c) for c in p]
    (x0, y0), (x1, y1), (x2, y2) = ((c[0], c[1]) for c in p)
    delta = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    if delta == 0:
        return []
    u_x, u_y, u_k = plane(p, [c[2] for c in p], delta)
    v_x, v_y, v_k = plane(p, [c[3] for c in p], delta)
    xs, ys = [c[0] for c in p], [c[1] for c in p]
    xa, xb = max(0, int(np.trunc(min(xs)))), min(WIDTH, int(np.trunc(max(xs))) + 1)
    ya, yb = max(0, int(np.trunc(min(ys)))), min(HEIGHT, int(np.trunc(max(ys))) + 1)
    if xa >= xb or ya >= yb:
        return []
    Y, X = (a.astype(np.float64) for a in np.mgrid[ya:yb, xa:xb])
    mask = np.ones(X.shape, dtype=bool)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        n_x, n_y = p[j][1] - p[i][1], p[i][0] - p[j][0]
        k = -(p[i][0] * n_x + p[i][1] * n_y)
        mask &= X * n_x + Y * n_y + k <= 0
    X, Y = X[mask], Y[mask]
    u, v = (X * u_x + Y * u_y) + u_k, (X * v_x + Y * v_y) + v_k
    columns = np.trunc(u).astype(np.int64) & (size[0] - 1)
    rows = np.trunc(v).astype(np.int64) & (size[1] - 1)
    out = []
    for n in range(len(X)):
        texel = address_texel(int(columns[n]), int(rows[n]))
        colour = [int(np.trunc(np.float64(c) * np.float64(light))) % 256 for c in texel]
        out.append(row_text(scene, int(X[n]), int(Y[n]), u[n], v[n], columns[n], rows[n], colour))
    return out


def main():
    args, rng = arguments(__doc__, 1000)
    scenes, expected = [], []
    for n in range(args.count):
        p = triangle(rng)
        light = light_of(rng)
        size = rng.choice([(32, 64), (64, 64), (256, 16), (1, 8), (512, 256)])
        wrap = rng.choice(["repeat", "mask"])
        scenes.append(scene_of(p, light, size, wrap, WIDTH, HEIGHT))
        expected.append(draw(n, p, light, size))
    return compare(args.texelscope, ["--method", "edge-equations", "--variant", "as-printed"], scenes, expected) > 0


if __name__ == "__main__":
    sys.exit(main())
