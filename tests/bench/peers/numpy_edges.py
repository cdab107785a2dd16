#!/usr/bin/python3
"""The triangles of a .tri file by edge equations in NumPy, each over its box at once, as S1's program draws them: what
people write first. Prints as `texelscope bench` does. In double; exact neither on sides nor at texels' borders.
    numpy_edges.py FILE.tri ROUNDS [OUT.ppm]"""
import pathlib
import statistics
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import triangles as tri  # noqa: E402


def address_pattern(width, height):
    """Pattern::address of core/image/patterns.h, 32 bits a texel, red lowest."""
    column, row = np.meshgrid(np.arange(width, dtype=np.uint32), np.arange(height, dtype=np.uint32))
    return np.uint32(0xFF010000) | (row & 255) << np.uint32(8) | column & 255


def draw(t, corners, texels, picture, depth):
    height, width = picture.shape
    tex_h, tex_w = texels.shape
    perspective, cull = t.flags & tri.PERSPECTIVE, t.flags & tri.CULL_BACK
    for p in corners:
        x, y = p[:, tri.X], p[:, tri.Y]
        area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
        if area == 0 or (cull and area < 0):
            continue
        x0, x1 = max(0, int(np.ceil(x.min() - 0.5))), min(width, int(np.ceil(x.max() - 0.5)))
        y0, y1 = max(0, int(np.ceil(y.min() - 0.5))), min(height, int(np.ceil(y.max() - 0.5)))
        if x0 >= x1 or y0 >= y1:
            continue
        column, row = np.arange(x0, x1) + 0.5, (np.arange(y0, y1) + 0.5)[:, None]
        sides, inside = [], None
        for n in range(3):
            i, j = (n + 1) % 3, (n + 2) % 3
            right, down = (y[i] - y[j]) / area, (x[j] - x[i]) / area
            side = (column - x[i]) * right + (row - y[i]) * down
            owned = side >= 0 if right > 0 or (right == 0 and down > 0) else side > 0
            inside = owned if inside is None else inside & owned
            sides.append(side)
        box = (slice(y0, y1), slice(x0, x1))
        if depth is not None:
            z = sum(s * p[n, tri.Z] for n, s in enumerate(sides)).astype(np.float32)
            inside &= z < depth[box]
            depth[box][inside] = z[inside]
        weights = [s[inside] for s in sides]
        if perspective:
            weights = [s / p[n, tri.W] for n, s in enumerate(weights)]
            one = sum(weights)
            weights = [s / one for s in weights]
        u = sum(s * p[n, tri.U] for n, s in enumerate(weights)) * tex_w
        v = sum(s * p[n, tri.V] for n, s in enumerate(weights)) * tex_h
        picture[box][inside] = texels[np.floor(v).astype(np.int64) % tex_h, np.floor(u).astype(np.int64) % tex_w]


def main():
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    path, rounds = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    t = tri.read(path)
    corners = t.corners.astype(np.float64)
    texels = address_pattern(*t.texture)
    picture = np.empty((t.height, t.width), np.uint32)
    depth = np.empty(picture.shape, np.float32) if t.flags & tri.DEPTH else None
    times = []
    for _ in range(rounds):
        picture.fill(0xFF000000)
        if depth is not None:
            depth.fill(1)
        start = time.perf_counter()
        draw(t, corners, texels, picture, depth)
        times.append((time.perf_counter() - start) * 1e3)
    median = statistics.median(times)
    print(f"numpy,t1,{path.stem},{median:.4f},{min(times):.4f},{t.covered / median / 1e3:.2f},{len(corners) / median / 1e3:.3f}")
    if len(sys.argv) > 3:
        rgb = picture.view(np.uint8).reshape(t.height, t.width, 4)[:, :, :3]
        pathlib.Path(sys.argv[3]).write_bytes(b"P6 %d %d 255\n" % (t.width, t.height) + rgb.tobytes())


if __name__ == "__main__":
    main()
