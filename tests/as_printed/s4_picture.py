"""The picture of S4: three quads at twice their size, each pixel of it, its reduction by 2, and the samples of the
diagonals, which both triangles of a quad write. Float64 in NumPy, written from the description.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
from collections import Counter

import numpy as np

from barycentric import samples, tinted
from comparison import rows_drawn
from pictures import decoded

WIDTH, HEIGHT = 1600, 600
BACKGROUND = (180, 179, 210)
CHECKS = 8  # along a side of the texture: c = 0.125
QUADS = [  # x, y, z of each corner; the texture's corners are (0, 0), (1, 0), (0, 1), (1, 1)
    [(50, 50, 1), (250, 50, 1), (50, 250, 1), (250, 250, 1)],
    [(350, 100, 1), (450, 100, 1), (300, 250, 1), (500, 250, 1)],
    [(600, 100, 2), (700, 100, 2), (550, 250, 1), (750, 250, 1)],
]
TWICE = [401, 301, 301]  # samples written twice in each quad
OPTIONS = ["--method", "barycentric", "--variant", "as-printed"]


def triangles():
    """Two for each quad, cut from the second corner to the third, doubled; u and v in checks."""
    for quad in QUADS:
        corners = [(2 * x, 2 * y, CHECKS * (n % 2), CHECKS * (n // 2), z) for n, (x, y, z) in enumerate(quad)]
        yield corners[:3]
        yield corners[1:]


def expected_picture():
    """The picture, and how often each sample is written."""
    picture = np.full((HEIGHT, WIDTH, 3), BACKGROUND, np.uint8)
    written = np.zeros((HEIGHT, WIDTH), int)
    for shape, corners in enumerate(triangles()):
        X, Y, u, v, edge = samples(corners, WIDTH, HEIGHT)
        white = (np.trunc(u).astype(int) ^ np.trunc(v).astype(int)) & 1
        colours = np.array([tinted([255 * w] * 3, shape) if e else [255 * w] * 3 for w, e in zip(white, edge)])
        at = Y.astype(int), X.astype(int)
        picture[at] = colours
        written[at] += 1
    return picture, written


def scene(texture):
    names = "x", "y", "u", "v", "w"
    polygons = [{"texture": "checker", "vertices": [dict(zip(names, c)) for c in t]} for t in triangles()]
    return {"texelscope": 1, "framebuffer": {"width": WIDTH, "height": HEIGHT, "clear": list(BACKGROUND)},
            "textures": [{"name": "checker"} | texture], "polygons": polygons}


def checker():
    """A PPM of one texel for each check, black where column xor row is even."""
    columns, rows = np.meshgrid(range(CHECKS), range(CHECKS))
    grey = ((columns ^ rows) & 1) * 255
    return b"P6 8 8 255\n" + np.repeat(grey.astype(np.uint8).ravel(), 3).tobytes()


def reduced(picture):
    """Half as large: a triangle over four samples each way, 1 3 3 1 eighths. The edges here are all background."""
    def halved(a):
        a = np.pad(a, [(1, 1)] + [(0, 0)] * (a.ndim - 1), mode="edge")
        return (a[0:-3:2] + 3 * a[1:-2:2] + 3 * a[2:-1:2] + a[3::2]) / 8
    return halved(halved(picture.astype(np.float64)).swapaxes(0, 1)).swapaxes(0, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--texelscope", required=True, help="the program under test")
    program = parser.parse_args().texelscope
    picture, written = expected_picture()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "checker.ppm").write_bytes(checker())
        (folder / "scene.json").write_text(json.dumps(scene({"file": "checker.ppm"})))
        def rendered(*options):
            command = [program, "render", str(folder / "scene.json"), "-o", str(folder / "out.png"), *OPTIONS, *options]
            subprocess.run(command, check=True)
            return decoded((folder / "out.png").read_bytes())
        whole, small = rendered(), rendered("--reduce", "2")
    different = int(np.any(whole != picture, axis=2).sum())
    print(f"{WIDTH}x{HEIGHT}: {written.sum()} samples written; {different} pixels differ")
    off = np.abs(small - reduced(picture)).max()
    print(f"reduced by 2: at most {off:.3f} levels apart")

    drawn = rows_drawn(program, OPTIONS, [scene({"pattern": "address", "size": [CHECKS, CHECKS]})])[0]
    times = Counter((int(p) // 2, x, y) for _, p, x, y, _ in (row.split(",", 4) for row in drawn))
    program_twice = [sum(n == 2 for (q, _, _), n in times.items() if q == quad) for quad in range(len(QUADS))]
    columns = [slice(2 * left, 2 * right) for left, right in ((0, 275), (275, 525), (525, 800))]
    here_twice = [int((written[:, columns[n]] == 2).sum()) for n in range(len(QUADS))]
    print(f"written twice: {here_twice} here, {program_twice} by the program, {TWICE} in the source")
    return different > 0 or off > 1 or not here_twice == program_twice == TWICE


if __name__ == "__main__":
    sys.exit(main())
