"""Closed meshes draw each pixel once: random planar subdivisions, with exact numbers, every corrected method but forward.

All corners are multiples of 1/256 pixel, so that what lies inside is decided here in whole numbers.
"""
import argparse
import json
import random
import subprocess
import sys
import tempfile
from collections import Counter

UNIT = 256  # of a pixel
WIDTH, HEIGHT = 28, 22


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])


def hull(points):
    """Corners of the convex hull, none on a straight side, in the direction of positive `cross`."""
    points = sorted(set(points))
    halves = []
    for order in (points, points[::-1]):
        chain = []
        for p in order:
            while len(chain) >= 2 and cross(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        halves.append(chain[:-1])
    return halves[0] + halves[1]


def split(triangles, p):
    """Puts the point into the triangle it lies in, or into both at the side it lies on."""
    out = []
    for a, b, c in triangles:
        sides = [(a, b, c), (b, c, a), (c, a, b)]
        signs = [cross(q, r, p) for q, r, _ in sides]
        if min(signs) < 0 or p in (a, b, c):
            out.append((a, b, c))
        elif 0 in signs:
            q, r, s = sides[signs.index(0)]
            out += [(q, p, s), (p, r, s)]
        else:
            out += [(q, r, p) for q, r, _ in sides]
    return out


def flip(triangles, rng):
    """Exchanges one diagonal where its quadrilateral is strictly convex."""
    one = rng.randrange(len(triangles))
    a, b, c = triangles[one]
    for other, t in enumerate(triangles):
        for n in range(3):
            if (t[n], t[(n + 1) % 3]) == (b, a):
                d = t[(n + 2) % 3]
                if cross(a, d, c) > 0 and cross(d, b, c) > 0:
                    triangles[one], triangles[other] = (a, d, c), (d, b, c)
                return


def point(rng, kind):
    if kind == "centres":  # right on samples
        return rng.randrange(-1, WIDTH + 1) * UNIT + UNIT // 2, rng.randrange(-1, HEIGHT + 1) * UNIT + UNIT // 2
    if kind == "halves":
        return rng.randrange(-2, 2 * WIDTH + 2) * UNIT // 2, rng.randrange(-2, 2 * HEIGHT + 2) * UNIT // 2
    return rng.randrange(-UNIT, (WIDTH + 1) * UNIT), rng.randrange(-UNIT, (HEIGHT + 1) * UNIT)


def mesh(rng):
    kind = rng.choice(["centres", "halves", "free"])
    outline = []
    while len(outline) < 3:
        outline = hull([point(rng, kind) for _ in range(rng.randint(3, 9))])
    triangles = [(outline[0], outline[n - 1], outline[n]) for n in range(2, len(outline))]
    for _ in range(rng.randint(0, 12)):
        p = point(rng, kind)
        if all(cross(outline[n - 1], outline[n], p) >= 0 for n in range(len(outline))):
            triangles = split(triangles, p)
    for _ in range(10):
        flip(triangles, rng)
    return outline, triangles


def scene(rng, triangles):
    polygons = []
    for corners in triangles:
        corners = list(corners)
        if rng.random() < 0.5:
            corners.reverse()
        start = rng.randrange(3)
        corners = corners[start:] + corners[:start]
        polygons.append({"vertices": [{"x": x / UNIT, "y": y / UNIT, "u": x / UNIT, "v": y / UNIT} for x, y in corners]})
    return {"texelscope": 1, "framebuffer": {"width": WIDTH, "height": HEIGHT}, "polygons": polygons}


def faults_of(outline, drawn):
    """Pixels drawn twice, or drawn outside, or inside and not drawn. On the outline either will do."""
    faults = []
    for y in range(HEIGHT):
        for x in range(WIDTH):
            sample = x * UNIT + UNIT // 2, y * UNIT + UNIT // 2
            least = min(cross(outline[n - 1], outline[n], sample) for n in range(len(outline)))
            allowed = (1,) if least > 0 else (0,) if least < 0 else (0, 1)
            if drawn[x, y] not in allowed:
                faults.append((x, y, drawn[x, y]))
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--texelscope", required=True)
    parser.add_argument("--seed", type=int, default=1995)
    parser.add_argument("--count", type=int, default=200, help="how many meshes")
    args = parser.parse_args()
    print(f"seed {args.seed}, {args.count} meshes")
    rng = random.Random(args.seed)
    meshes = [mesh(rng) for _ in range(args.count)]
    scenes = [json.dumps(scene(rng, triangles)) for _, triangles in meshes]
    failed = False
    for method in ("edge-equations", "sections", "edge-walk", "barycentric", "backward-affine", "backward-projective",
                   "constant-z", "two-pass", "subdivided", "sampling-1d"):
        with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
            file.write("\n".join(scenes) + "\n")
            file.flush()
            options = ["--method", method, "--variant", "corrected", "--number", "exact"]
            run = subprocess.run([args.texelscope, "pixels", "--lines", file.name] + options, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"the program failed: {run.stderr}")
        drawn = [Counter() for _ in meshes]
        for line in run.stdout.splitlines()[1:]:
            n, _, x, y, _ = line.split(",", 4)
            drawn[int(n)][int(x), int(y)] += 1
        bad = [(n, faults) for n in range(len(meshes)) if (faults := faults_of(meshes[n][0], drawn[n]))]
        for n, faults in bad[:3]:
            print(f"{method}: mesh {n}: (x, y, times drawn) {faults[:5]}: {scenes[n]}")
        triangles = sum(len(t) for _, t in meshes)
        print(f"{method}: {triangles} triangles, {sum(d.total() for d in drawn)} samples; {len(bad)} meshes with faults")
        failed |= bool(bad)
    return failed


if __name__ == "__main__":
    sys.exit(main())
