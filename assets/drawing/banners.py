"""Four wide faces in flat colours, each with a word: what a torus wears to show which side is which."""
import math

import numpy as np

from drawing.glyphs import word_distance
from drawing.noise import pick
from drawing.palette import colour

WIDTH, HEIGHT = 512, 256
STEPS = 4  # of coverage at an edge, so that few colours arise


def places():
    """The middles of all pixels, x and y."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH] + 0.5
    return x, y


def cover(picture, distance, ink):
    """Paints where the distance is negative, with a soft edge one pixel wide."""
    part = np.round(np.clip(0.5 - np.round(distance, 6), 0, 1) * STEPS).astype(np.int64)[..., None]
    picture[:] = (picture * (STEPS - part) + ink * part + STEPS // 2) // STEPS


def sheet(name, shade):
    """A face of one colour, wide enough in its numbers for mixing."""
    return np.zeros((HEIGHT, WIDTH, 3), np.int64) + colour(name, shade)


def frame(picture, name):
    """Two lines around the face."""
    x, y = places()
    rim = np.minimum(np.minimum(x, WIDTH - x), np.minimum(y, HEIGHT - y))
    picture[rim < 10] = colour(name, 13)
    picture[rim < 6] = colour(name, 3)


def lettering(picture, word, dark, ink, width=80, half=13, gap=10, grid=1):
    """The word in the middle with a cast shadow and an outline. `grid` > 1 draws it in squares of that many pixels."""
    x, y = places()
    if grid > 1:
        x, y = (np.floor(x / grid) + 0.5) * grid, (np.floor(y / grid) + 0.5) * grid
    sharp, rim = (1, 6) if grid == 1 else (1000, grid)  # a square is covered or not
    middle = WIDTH / 2, HEIGHT / 2
    cast = [word_distance(x - n, y - n, word, middle, 112, width, half, gap, grid) for n in range(0, 13, max(2, grid))]
    cover(picture, (np.minimum.reduce(cast) - rim) * sharp, dark)
    cover(picture, cast[0] * sharp, ink)
    return cast[0]


def texel():
    """A mosaic of squares that goes from blue to turquoise."""
    picture = sheet("blue", 5)
    for row in range(8):
        for column in range(16):
            lit = pick(81, row, column)
            name = "gold" if lit > 0.95 else "sea" if column + 6 * lit > 11 else "blue"
            shade = 10 if name == "gold" else 5 + int(4 * pick(82, row, column))
            picture[32 * row + 1:32 * row + 31, 32 * column + 1:32 * column + 31] = colour(name, shade)
    frame(picture, "sea")
    lettering(picture, "TEXEL", colour("blue", 1), colour("sand", 15))
    return picture.astype(np.uint8)


def pixel():
    """Rays from the middle, and the word in large squares."""
    picture, (x, y) = sheet("red", 6), places()
    for ray in range(12):
        turn = (ray + 0.5) * math.pi / 12
        across = (x - WIDTH / 2) * math.sin(turn) - (y - HEIGHT / 2) * math.cos(turn)
        along = (x - WIDTH / 2) * math.cos(turn) + (y - HEIGHT / 2) * math.sin(turn)
        cover(picture, np.abs(across) - np.abs(along) * math.tan(math.pi / 48), colour("fire", 10))
    far = np.sqrt((x - WIDTH / 2)**2 + (y - HEIGHT / 2)**2)
    cover(picture, np.abs(far - 112) - 6, colour("gold", 12))
    frame(picture, "gold")
    lettering(picture, "PIXEL", colour("red", 1), colour("gold", 14), 88, 16, 16, 8)
    return picture.astype(np.uint8)


def crossings(corners, y):
    """Where the row `y` enters and leaves a triangle; twice the same place if it misses it."""
    found = []
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        if min(ay, by) <= y < max(ay, by):
            found.append(ax + (bx - ax) * (y - ay) / (by - ay))
    return sorted(found) if found else [0, 0]


def span():
    """A large triangle drawn span by span, the first and last square of each in gold."""
    picture, (x, y) = sheet("leaf", 5), places()
    picture[np.floor(y) % 16 == 0] = colour("leaf", 4)
    for top in range(0, HEIGHT, 16):
        left, right = (round(at / 16) * 16 for at in crossings([(352, 0), (16, 150), (496, 250)], top + 8))
        if right > left:
            picture[top + 2:top + 15, left:right] = colour("grass", 8)
            picture[top + 2:top + 15, left:left + 16] = picture[top + 2:top + 15, right - 16:right] = colour("gold", 11)
    frame(picture, "grass")
    body = lettering(picture, "SPAN", colour("leaf", 1), colour("sand", 15), 96, 15, 12)
    cover(picture, np.maximum(body, np.abs(y % 16 - 8) - 1), colour("leaf", 7))
    return picture.astype(np.uint8)


def corner(row, column):
    """A corner of the crumpled grid [px]."""
    inside = 0 < row < 4 and 0 < column < 8
    move = [40 * (pick(95 + n, row, column) - 0.5) if inside else 0 for n in range(2)]
    return 64 * column + move[0], 64 * row + move[1]


def fill_triangle(picture, a, b, c, ink):
    """Paints the triangle a little smaller than it is, so that its sides stay as lines."""
    x, y = places()
    sides = []
    for p, q in ((a, b), (b, c), (c, a)):
        dx, dy = q[0] - p[0], q[1] - p[1]
        sides.append(((x - p[0]) * dy - (y - p[1]) * dx) / math.sqrt(dx * dx + dy * dy))
    cover(picture, np.maximum.reduce(sides) + 1.2, ink)


def edge():
    """A net of triangles whose sides are drawn."""
    picture = sheet("rose", 13)
    for row in range(4):
        for column in range(8):
            a, b, c, d = (corner(row + n // 2, column + n % 2) for n in range(4))
            for n, triangle in enumerate(((a, b, c), (b, d, c))):
                tone = pick(98, row, column, n)
                fill_triangle(picture, *triangle, colour("violet" if tone < 0.7 else "rose", 4 + int(5 * tone)))
    frame(picture, "rose")
    lettering(picture, "EDGE", colour("violet", 1), colour("gold", 13), 96, 15, 12)
    return picture.astype(np.uint8)
