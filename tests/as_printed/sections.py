"""Sections as printed (S2): float64, written from the description, compared row for row, ghosts among them.

A polygon has one row buffer, zeroed at its start. Each section fills it from slot 0 on, one slot for each pixel, and
then draws the slots it counted. A row of one pixel is counted but not filled in.
"""
import math
import sys

import numpy as np

from comparison import address_texel, arguments, compare, light_of, lit, row_text, scene_of, single, wrapped

WIDTH, HEIGHT = 48, 40


def polygon(rng):
    """Corners on a random ellipse, in order: convex."""
    kind = rng.choice(["plain", "plain", "integer", "quarter", "narrow", "off_screen", "spike"])
    count = rng.randint(3, 8)
    reach = 60 if kind == "off_screen" else 22
    a, b = rng.uniform(1, reach), rng.uniform(1, reach)
    if kind in ("narrow", "spike"):
        a = rng.uniform(0.5, 2.5)
    tilt = rng.choice([0, 0, rng.uniform(0, math.pi)])
    centre = rng.uniform(0, WIDTH), rng.uniform(0, HEIGHT)
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(count))
    ring = []
    for angle in angles:
        x, y = a * math.cos(angle), b * math.sin(angle)
        x, y = x * math.cos(tilt) - y * math.sin(tilt), x * math.sin(tilt) + y * math.cos(tilt)
        ring.append((x + centre[0], y + centre[1]))
    if kind == "integer":
        ring = [(round(x), round(y)) for x, y in ring]
    if kind == "quarter":
        ring = [(round(4 * x) / 4, round(4 * y) / 4) for x, y in ring]
    if rng.random() < 0.5:
        ring.reverse()
    start = rng.randrange(count)
    ring = ring[start:] + ring[:start]
    whole = rng.random() < 0.3
    texture = [(rng.uniform(-40, 80), rng.uniform(-40, 80)) for _ in ring]
    if whole:
        texture = [(round(u), round(v)) for u, v in texture]
    return [[single(x), single(y), single(u), single(v)] for (x, y), (u, v) in zip(ring, texture)]


def to_whole(x):
    """Round half to even."""
    return int(np.rint(x))


def side_at(node, following, y):
    """Where row y meets the side from `node` to `following`: x in whole pixels, and the image point."""
    m = (np.float64(y) - node[1]) / (following[1] - node[1])
    x = to_whole(node[0] + m * (following[0] - node[0]))
    return x, node[2] + m * (following[2] - node[2]), node[3] + m * (following[3] - node[3])


def row_pixels(y, left, right):
    """The pixels of a row from the left end up to but without the right one, whichever way that is."""
    (x_left, u_left, v_left), (x_right, u_right, v_right) = left, right
    step = 1 if x_left <= x_right else -1
    xs = list(range(x_left, x_right, step))
    pixels = []
    for x in xs:
        s = np.float64(x - xs[0]) / np.float64(xs[-1] - xs[0])
        pixels.append((x, y, u_left + s * (u_right - u_left), v_left + s * (v_right - v_left)))
    return pixels


def sections(ring):
    """(y_beg, y_end, left side, right side) from the top down."""
    n = len(ring)
    top = min(range(n), key=lambda i: (ring[i][1], i))
    left = right = top
    y = ring[top][1]
    for _ in range(n - 1):
        left_next, right_next = ring[(left - 1) % n], ring[(right + 1) % n]
        take_right = right_next[1] < left_next[1]
        y_end = (right_next if take_right else left_next)[1]
        yield int(y), int(y_end), (ring[left], left_next), (ring[right], right_next)
        if take_right:
            right = (right + 1) % n
        else:
            left = (left - 1) % n
        y = y_end


def draw(scene, corners, light, size, wrap):
    ring = [(np.trunc(np.float64(x)), np.trunc(np.float64(y)), np.float64(u), np.float64(v)) for x, y, u, v in corners]
    buffer, out = {}, []
    for y_beg, y_end, left, right in sections(ring):
        slot, stale = 0, set()
        for y in range(y_beg, y_end):
            ends = side_at(*left, y), side_at(*right, y)
            length = abs(ends[0][0] - ends[1][0])
            if length == 1:
                stale.add(slot)
            else:
                for n, pixel in enumerate(row_pixels(y, *ends)):
                    buffer[slot + n] = pixel
            slot += length
        for n in range(slot):
            x, y, u, v = buffer.get(n, (0, 0, np.float64(0), np.float64(0)))
            if not (0 <= x < WIDTH and 0 <= y < HEIGHT):
                continue
            column, row = wrapped(int(np.trunc(u)), size[0], wrap), wrapped(int(np.trunc(v)), size[1], wrap)
            colour = lit(address_texel(column, row), light)
            out.append(row_text(scene, x, y, u, v, column, row, colour, "ghost" if n in stale else ""))
    return out


def main():
    args, rng = arguments(__doc__, 500)
    scenes, expected = [], []
    for n in range(args.count):
        corners = polygon(rng)
        light = light_of(rng)
        wrap = rng.choice(["repeat", "mask", "clamp"])
        size = rng.choice([(32, 64), (64, 64), (256, 16)] + [(48, 10), (7, 300)] * (wrap != "mask"))
        scenes.append(scene_of(corners, light, size, wrap, WIDTH, HEIGHT))
        expected.append(draw(n, corners, light, size, wrap))
    ghosts = sum(row.endswith(",ghost") for rows in expected for row in rows)
    print(f"{ghosts} ghost pixels")
    if ghosts < args.count // 20:
        sys.exit("too few ghosts to compare: draw other polygons")
    return compare(args.texelscope, ["--method", "sections", "--variant", "as-printed"], scenes, expected) > 0


if __name__ == "__main__":
    sys.exit(main())
