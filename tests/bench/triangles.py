"""`.tri` files (core/scene/triangles_file.h), read and written."""
import dataclasses
import pathlib
import struct

import numpy as np

HEADER = struct.Struct("<8s8I3Q")
MAGIC = b"TRIWL01\0"
PERSPECTIVE, DEPTH, CULL_BACK, NO_WRAP = 1, 2, 4, 8
X, Y, Z, W, U, V = range(6)


@dataclasses.dataclass
class Triangles:
    corners: np.ndarray  # float32, triangles x 3 x (x, y, z, w, u, v)
    width: int = 1024
    height: int = 1024
    flags: int = 0
    texture: tuple = (256, 256)
    seed: int = 0
    covered: int = 0


def read(path):
    data = pathlib.Path(path).read_bytes()
    magic, width, height, count, flags, *rest = HEADER.unpack_from(data)
    tex_w, tex_h, vertex_bytes, _, seed, covered, _ = rest
    if magic != MAGIC or vertex_bytes != 24 or len(data) != HEADER.size + 72 * count:
        raise SystemExit(f"{path}: not a whole .tri file")
    corners = np.frombuffer(data, "<f4", 18 * count, HEADER.size).reshape(count, 3, 6)
    return Triangles(corners, width, height, flags, (tex_w, tex_h), seed, covered)


def write(path, t):
    head = HEADER.pack(MAGIC, t.width, t.height, len(t.corners), t.flags, *t.texture, 24, 0, t.seed, t.covered, 0)
    pathlib.Path(path).write_bytes(head + np.ascontiguousarray(t.corners, "<f4").tobytes())
