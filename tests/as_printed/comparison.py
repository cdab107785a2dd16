"""Draws scenes with the program and compares its rows with rows that were computed here."""
import argparse
import json
import random
import subprocess
import sys
import tempfile

import numpy as np

HEADER = "scene,polygon,x,y,u,v,texel_x,texel_y,r,g,b,note"


def arguments(description, count):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--texelscope", required=True, help="the program under test")
    parser.add_argument("--seed", type=int, default=1995)
    parser.add_argument("--count", type=int, default=count, help="how many scenes")
    args = parser.parse_args()
    print(f"seed {args.seed}, {args.count} scenes")
    return args, random.Random(args.seed)


def single(x):
    """The nearest float32, as the float64 that all arithmetic starts from."""
    return float(np.float32(x))


def address_texel(column, row):
    """The scene's only texture is an address pattern; the first texture's mark is 1."""
    return column & 255, row & 255, 1


def light_of(rng):
    return single(rng.choice([1, 1, 0, 0.5, rng.random(), rng.uniform(1, 4), 2, 1000.25]))


def whole(x):
    """Truncated; a number without a value gives 0."""
    return 0 if np.isnan(x) else int(np.trunc(x))


def below(x):
    """The whole number at or below; a number without a value gives 0."""
    return 0 if np.isnan(x) else int(np.floor(x))


def wrapped(index, size, wrap):
    if wrap == "clamp":
        return min(max(index, 0), size - 1)
    return index & (size - 1) if wrap == "mask" else index % size


def lit(texel, light):
    return [min(255, int(np.trunc(np.float64(channel) * np.float64(light)))) for channel in texel]


def scene_of(polygon_vertices, light, size, wrap, width, height):
    """One polygon; its corners are x, y, u, v and, if they have a depth, w."""
    vertices = [dict(zip(("x", "y", "u", "v", "w"), corner)) for corner in polygon_vertices]
    return {
        "texelscope": 1,
        "framebuffer": {"width": width, "height": height},
        "textures": [{"name": "t", "pattern": "address", "size": list(size), "wrap": wrap}],
        "polygons": [{"texture": "t", "light": light, "vertices": vertices}],
    }


def row_text(scene, x, y, u, v, column, row, colour, note=""):
    return f"{scene},0,{x},{y},{u:.17g},{v:.17g},{column},{row},{colour[0]},{colour[1]},{colour[2]},{note}"


def sample_text(scene, x, y, u, v, light, size, wrap):
    """The row of a sample whose texel is found by floor and wrap mode."""
    column, row = wrapped(below(u), size[0], wrap), wrapped(below(v), size[1], wrap)
    return row_text(scene, x, y, u, v, column, row, lit(address_texel(column, row), light))


def rows_drawn(program, options, scenes):
    """What the program prints for each scene."""
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
        for scene in scenes:
            file.write(json.dumps(scene) + "\n")
        file.flush()
        run = subprocess.run([program, "pixels", "--lines", file.name] + options, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"the program failed: {run.stderr}")
    lines = run.stdout.splitlines()
    if lines[0] != HEADER:
        sys.exit(f"header is {lines[0]}")
    found = [[] for _ in scenes]
    for line in lines[1:]:
        found[int(line[: line.index(",")])].append(line)
    return found


def compare(program, options, scenes, expected):
    """`expected`: a list of rows for each scene. Returns how many scenes differ, and prints the first ones."""
    found = rows_drawn(program, options, scenes)
    different = [n for n in range(len(scenes)) if found[n] != expected[n]]
    for n in different[:3]:
        print(f"scene {n} differs: {json.dumps(scenes[n])}")
        print(f"  {len(expected[n])} rows here, {len(found[n])} from the program")
        pairs = [(a, b) for a, b in zip(expected[n] + [""] * 9, found[n] + [""] * 9) if a != b]
        for here, there in pairs[:3]:
            print(f"  here    {here}\n  program {there}")
    rows = sum(len(rows) for rows in expected)
    drawn = sum(1 for rows in expected if rows)
    print(f"{rows} rows in {drawn} scenes that draw anything; {len(different)} scenes differ")
    return len(different)
