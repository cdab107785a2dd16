#!/usr/bin/python3
"""Draws the pictures of assets/ that are computed: `make.py` writes them, `make.py --check` compares them.

The check fails if a file is not what would be written, or if LICENSE.md does not name a picture that is there.
"""
import argparse
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from drawing import banners, cards, flame, marbles, palette, png, surfaces, world  # noqa: E402

FOLDER = Path(__file__).resolve().parent
PICTURES = {
    "textures/bricks.png": surfaces.bricks,
    "textures/wood.png": surfaces.wood,
    "textures/crate.png": surfaces.crate,
    "textures/floor.png": surfaces.floor,
    "textures/letters.png": cards.letters,
    "textures/uv-card.png": cards.uv_card,
    "textures/gradient-1d.png": cards.gradient_1d,
    "textures/checker-8.png": cards.checker_8,
    "textures/world.png": world.world,
    "textures/banner-1.png": banners.texel,
    "textures/banner-2.png": banners.pixel,
    "textures/banner-3.png": banners.span,
    "textures/banner-4.png": banners.edge,
    "textures/flame.png": flame.flame,
    "textures/marbles.png": marbles.marbles,
    "palettes/vga-1995.png": palette.vga_1995,
}
MOST_BYTES = 300_000  # of all of them together


def up_to_date(name, file):
    """Whether the tree has this file, whatever version of zlib packed it."""
    path = FOLDER / name
    return path.is_file() and png.same(path.read_bytes(), file)


def write(files):
    """Writes what is missing or differs, and says so."""
    for name, file in files.items():
        if not up_to_date(name, file):
            (FOLDER / name).parent.mkdir(exist_ok=True)
            (FOLDER / name).write_bytes(file)
            print("wrote", name, len(file), "bytes")


def faults(files):
    """What the check finds wrong, one line each."""
    found = [f"{name} is not what make.py draws" for name, file in files.items() if not up_to_date(name, file)]
    total = sum((FOLDER / name).stat().st_size for name in files if (FOLDER / name).is_file())
    if total > MOST_BYTES:
        found.append(f"the pictures take {total} bytes, expected at most {MOST_BYTES}")
    licences = (FOLDER / "LICENSE.md").read_text(encoding="utf-8")
    there = sorted(path.relative_to(FOLDER).as_posix() for path in FOLDER.glob("*/*.png"))
    return found + [f"LICENSE.md has no row for {name}" for name in there if f"| {name} |" not in licences]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare the files and write nothing")
    check = parser.parse_args().check
    files = {name: png.encode(draw()) for name, draw in PICTURES.items()}
    if not check:
        write(files)
    found = faults(files)
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
