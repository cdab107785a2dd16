"""Shapes whose samples lie on the borders of texels, as blits and simple ratios put them there, and the same shapes
without ties: u and v shifted, and their slopes off by one in a thousand."""
import numpy as np

import triangles as tri

SIDE, TEXTURE = 1024, 256
SIZES = (48, 64, 400)  # px
RATIOS = {"1-1": (1, 1), "1-2": (1, 2), "3-2": (3, 2), "5-48": (5, 48)}  # texels for pixels
PIXELS = 4e6           # of a file, about


def squares(size):
    """Left, top corners of squares that lie side by side, corners on centres of pixels; again and again."""
    starts = np.arange(0, SIDE - size, size) + 0.5
    left, top = (a.ravel() for a in np.meshgrid(starts, starts))
    repeat = int(np.ceil(PIXELS / (len(left) * size * size)))
    return np.tile(left, repeat), np.tile(top, repeat)


def shapes(size, slope, shift, w):
    """Two triangles a square; u and v grow by `slope` texels a pixel at w = 1."""
    left, top = squares(size)
    corners = np.zeros((len(left), 2, 3, 6), np.float32)
    for t, places in enumerate((((0, 0), (1, 0), (0, 1)), ((1, 0), (1, 1), (0, 1)))):
        for c, (right, down) in enumerate(places):
            corners[:, t, c, tri.X] = left + size * right
            corners[:, t, c, tri.Y] = top + size * down
            corners[:, t, c, tri.W] = w[right]
            # Texels may be read from anywhere, but from whole ones where they are to tie.
            corners[:, t, c, tri.U] = (np.floor(left % 97) + slope * size * right + shift) / TEXTURE
            corners[:, t, c, tri.V] = (np.floor(top % 89) + slope * size * down + shift * 1.7) / TEXTURE
    return corners.reshape(-1, 3, 6)


def make(folder):
    """Pairs of files: without ties, with them."""
    pairs = []
    for kind, w, flags in (("affine", (1, 1), 0), ("perspective", (1, 2), tri.PERSPECTIVE)):
        for size in SIZES:
            for name, (texels, pixels) in RATIOS.items():
                pair = []
                for word, slope, shift in (("free", texels / pixels * 1.001, 0.37), ("tied", texels / pixels, 0)):
                    path = folder / f"{kind}-{size}px-{name}-{word}.tri"
                    tri.write(path, tri.Triangles(shapes(size, slope, shift, w), SIDE, SIDE, flags, (TEXTURE, TEXTURE)))
                    pair.append(path)
                pairs.append(tuple(pair))
    return pairs
