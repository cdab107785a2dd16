"""The torus of S1's own program, drawn here with NumPy from the description and compared pixel for pixel.

13 x 7 quads, radii 1.5 and 0.5, at 1920x1080; turned in the planes xy, xz and yz by the angles a, b, c; the farthest
face first, by the depth of its first corner; two triangles a face. All that comes before pixels is in double: corners,
light, planes. The arrays hold float32, and so each sum and product of a pixel is one of float32.
"""
import argparse
import json
import math
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

import numpy as np

from comparison import single
from pictures import differing

ASSETS = pathlib.Path(__file__).resolve().parents[2] / "assets"
sys.path.insert(0, str(ASSETS))
from drawing import banners  # noqa: E402

RING, RINGS = 7, 13
TEXTURES = [banners.texel(), banners.pixel(), banners.span(), banners.edge()]


def rotated(p, q, angle):
    c, s = math.cos(angle), math.sin(angle)
    return p * c + q * s, q * c - p * s


def corners(angles):
    """x, y, z of all corners, ring by ring."""
    for ring in range(RINGS):
        for n in range(RING):
            turn = n * 2 * math.pi / RING
            x, y = 1.5 + 0.5 * math.cos(turn), 0.5 * math.sin(turn)
            x, z = rotated(x, 0.0, ring * 2 * math.pi / RINGS)
            x, y = rotated(x, y, angles[0])
            x, z = rotated(x, z, angles[1])
            y, z = rotated(y, z, angles[2])
            yield x, y, z


def faces():
    """The texture's number, and the corners a, b, c, d of each face."""
    for ring in range(RINGS):
        after = (ring + 1) % RINGS
        for n in range(RING):
            beside = (n + 1) % RING
            yield ((n * RINGS + ring) % len(TEXTURES), beside + ring * RING, beside + after * RING, n + after * RING,
                   n + ring * RING)


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def light(a, b, c):
    """0.5 + 0.49 |n_z| of a face that has the three corners."""
    normal = cross([p - q for p, q in zip(c, a)], [p - q for p, q in zip(b, a)])
    return 0.5 + 0.49 * abs(normal[2] / sum(n * n for n in normal) ** 0.5)


def plane(p, value, delta):
    (x0, y0), (x1, y1), (x2, y2) = p
    f0, f1, f2 = value
    f_x = ((f1 - f0) * (y2 - y0) - (f2 - f0) * (y1 - y0)) / delta
    f_y = ((x1 - x0) * (f2 - f0) - (x2 - x0) * (f1 - f0)) / delta
    return f_x, f_y, f0 - x0 * f_x - y0 * f_y


def affine(x, y, factors):
    f_x, f_y, f_k = (np.float32(f) for f in factors)
    return x * f_x + y * f_y + f_k


def draw_triangle(picture, p, u, v, level, texture):
    height, width, _ = picture.shape
    (x0, y0), (x1, y1), (x2, y2) = p
    delta = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    xs, ys = (x0, x1, x2), (y0, y1, y2)
    left, right = max(0, int(min(xs))), min(width, int(max(xs)) + 1)
    top, bottom = max(0, int(min(ys))), min(height, int(max(ys)) + 1)
    if delta == 0 or left >= right or top >= bottom:
        return
    x, y = np.meshgrid(np.float32(np.arange(left, right) + 0.5), np.float32(np.arange(top, bottom) + 0.5))
    mask = np.ones(x.shape, bool)
    for (px, py), (qx, qy) in zip(p, p[1:] + p[:1]):
        n_x, n_y = qy - py, px - qx
        mask &= affine(x, y, (n_x, n_y, -(px * n_x + py * n_y))) <= 0
    x, y = x[mask], y[mask]
    columns, rows = affine(x, y, plane(p, u, delta)), affine(x, y, plane(p, v, delta))
    assert columns.dtype == rows.dtype == np.float32
    texels = texture[rows.astype(np.int32) & (texture.shape[0] - 1), columns.astype(np.int32) & (texture.shape[1] - 1)]
    picture[top:bottom, left:right][mask] = (texels * level).astype(np.int32)


def torus(angles, width, height):
    """The picture."""
    world = list(corners(angles))
    screen = [(width / 2 + x * width / (8 + z), height / 2 - y * width / (8 + z)) for x, y, z in world]
    picture = np.zeros((height, width, 3), np.uint8)
    for number, *ring in sorted(faces(), key=lambda face: -world[face[1]][2]):
        a, b, c, d = (screen[n] for n in ring)
        if (b[0] - c[0]) * (a[1] - c[1]) - (b[1] - c[1]) * (a[0] - c[0]) <= 0:
            continue
        texture, level = TEXTURES[number], light(*(world[n] for n in ring[:3]))
        h, w, _ = texture.shape
        draw_triangle(picture, [b, a, c], (w, 0, w), (h, h, 0), level, texture)
        draw_triangle(picture, [c, a, d], (w, 0, 0), (0, h, 0), level, texture)
    return picture


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--texelscope", required=True, help="the program under test")
    parser.add_argument("--seed", type=int, default=1995)
    parser.add_argument("--count", type=int, default=12, help="how many rotations beside the scene's own")
    args = parser.parse_args()
    rng, wrong = random.Random(args.seed), 0
    shipped = ASSETS / "scenes" / "s1-torus.json"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path in (ASSETS / "textures").glob("banner-*.png"):
            shutil.copy(path, folder)
        scene = json.loads(shipped.read_text())
        for texture in scene["textures"]:
            texture["file"] = pathlib.Path(texture["file"]).name
        own = scene["meshes"][0]["rotate"]
        for n in range(args.count + 1):
            turn = own if n == 0 else [single(rng.uniform(-180, 180)) for _ in range(3)]
            frame = scene["framebuffer"]
            if n > args.count // 2:  # smaller ones are drawn sooner
                frame["width"], frame["height"] = rng.randint(200, 700), rng.randint(150, 500)
                scene["camera"]["focal"] = frame["width"]
            scene["meshes"][0]["rotate"] = turn
            (folder / "scene.json").write_text(json.dumps(scene))
            file = shipped if n == 0 else folder / "scene.json"
            out = folder / "out.png"
            subprocess.run([args.texelscope, "render", str(file), "-o", str(out), "--variant", "as-published"],
                           check=True)
            picture = torus([math.radians(degrees) for degrees in reversed(turn)], frame["width"], frame["height"])
            different = differing(out.read_bytes(), picture)
            wrong += different
            print(f"{frame['width']}x{frame['height']} rotated {turn}: {int(picture.any(axis=2).sum())} pixels drawn, "
                  f"{different} differ")
    print(f"seed {args.seed}: {wrong} pixels differ")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
