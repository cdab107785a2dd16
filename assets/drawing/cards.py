"""Test cards: pictures in which each part says where it belongs."""
import numpy as np

from drawing.glyphs import BOLD, SMALL, dots
from drawing.palette import colour, painted

DARK, LIGHT = colour("steel", 1), colour("sand", 15)


def stamp(picture, mask, top, left, ink):
    """Paints where the mask is set, its corner at the given place."""
    part = picture[top:top + mask.shape[0], left:left + mask.shape[1]]
    part[mask] = ink


def grown(mask):
    """The mask and the eight neighbours of each of its pixels."""
    wide = np.pad(mask, 1)
    rows = wide[:-2] | wide[1:-1] | wide[2:]
    return rows[:, :-2] | rows[:, 1:-1] | rows[:, 2:]


def boxes(size, *rectangles):
    """The mask of rectangles given as top, left, height, width."""
    mask = np.zeros(size, bool)
    for top, left, height, width in rectangles:
        mask[top:top + height, left:left + width] = True
    return mask


def raised(picture, mask, name, shade):
    """Paints the mask as a raised shape: an outline, a shadow, light from the upper left."""
    outline = grown(mask)
    shadow = np.roll(outline, (2, 2), axis=(0, 1)) & ~outline
    picture[shadow] = picture[shadow] // 2
    picture[outline] = DARK
    picture[mask] = colour(name, shade)
    picture[mask & ~np.roll(mask, (-1, -1), axis=(0, 1))] = colour(name, shade - 4)
    picture[mask & ~np.roll(mask, (1, 1), axis=(0, 1))] = colour(name, 15)


def letters():
    """A large F, which no mirror or turn leaves alone, on four colours lettered A to D."""
    y, x = np.mgrid[0:64, 0:64]
    picture = np.zeros((64, 64, 3), np.uint8)
    for n, name in enumerate(("red", "blue", "grass", "violet")):
        top, left = 32 * (n // 2), 32 * (n % 2)
        level = 7.0 + (y // 8 + x // 8) % 2
        part = np.s_[top:top + 32, left:left + 32]
        picture[part] = painted(name, level)[part]
    picture[(y % 63 == 0) | (x % 63 == 0)] = LIGHT
    raised(picture, boxes((64, 64), (9, 20, 46, 9), (9, 20, 9, 27), (27, 20, 9, 21)), "gold", 12)
    for n, letter in enumerate("ABCD"):
        top, left = (4, 52)[n // 2], (4, 52)[n % 2]
        picture[top - 2:top + 10, left - 2:left + 10] = DARK
        stamp(picture, dots(BOLD[letter]), top, left, LIGHT)
    return picture


def hue(sixtieths, low, high):
    """A colour of full strength between `low` and `high` [0, 255]; a turn has 384 steps."""
    sector, part = divmod(sixtieths % 384, 64)
    up, down = low + (high - low) * part // 64, high - (high - low) * part // 64
    return [(high, up, low), (down, high, low), (low, high, up), (low, down, high), (up, low, high),
            (high, low, down)][sector]


def cell(row, column):
    """A cell of the card: a hue of its own, lighter and darker in turn, and its name."""
    high = 250 if (row + column) % 2 else 205
    picture = np.empty((16, 16, 3), np.uint8)
    picture[:] = hue(48 * column + 6 * row, high // 2, high)
    picture[0] = picture[:, 0] = LIGHT
    stamp(picture, dots(SMALL["ABCDEFGH"[column]]), 5, 3, DARK)
    stamp(picture, dots(SMALL["12345678"[row]]), 5, 9, DARK)
    return picture


def arrow(length):
    """The mask of an arrow to the right, seven high, with a margin of one."""
    mask = boxes((9, length + 2), (4, 1, 1, length - 4))
    for n in range(4):
        mask[1 + n:8 - n, length - 3 + n] = True
    return mask


def place_axis(picture, letter, across):
    """An arrow along the line between the first and second cells, and its letter where that line meets another.

    Both lie where no cell has its name.
    """
    turned = picture if across else picture.transpose(1, 0, 2)
    shape = arrow(51)
    stamp(turned, grown(shape), 12, 15, LIGHT)
    stamp(turned, shape, 12, 15, DARK)
    turned[13:20, 77:84] = DARK
    glyph = dots(SMALL[letter])[2:]
    stamp(turned, glyph if across else glyph.T, 14, 78, LIGHT)


def uv_card():
    """Eight by eight cells from A1 at the top left to H8; u counts letters, v counts numbers."""
    picture = np.vstack([np.hstack([cell(row, column) for column in range(8)]) for row in range(8)])
    picture[[0, -1]] = picture[:, [0, -1]] = DARK
    place_axis(picture, "v", False)
    place_axis(picture, "u", True)
    return picture


def gradient_1d():
    """Eight texels in the order of the rainbow."""
    texels = {"red": 8, "fire": 10, "gold": 12, "grass": 9, "sea": 10, "blue": 8, "violet": 8, "rose": 11}
    return np.array([[colour(name, shade) for name, shade in texels.items()]], np.uint8)


def checker_8():
    """Texel (i, j) is black where i xor j is even, white elsewhere: the checks of S4."""
    y, x = np.mgrid[0:8, 0:8]
    return np.repeat(np.where((x ^ y) % 2 == 0, 0, 255).astype(np.uint8)[:, :, None], 3, axis=2)
