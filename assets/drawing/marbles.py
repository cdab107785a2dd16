"""Glass marbles: one in each ramp of the palette, so that a texture of 64 x 64 has all of its 256 colours."""
import numpy as np

from drawing.palette import COLOURS, SHADES, painted

CELL, SIDE = 16, 4  # texels of a marble and its surroundings; marbles in a row
RADIUS = 7.4


def marble():
    """Shades of one: lit from the upper left, bright again at the lower right where the light comes out."""
    y, x = np.mgrid[0:CELL, 0:CELL] + 0.5 - CELL / 2
    far = np.sqrt(x * x + y * y) / RADIUS
    height = np.sqrt(np.clip(1 - far * far, 0, 1))
    through = np.clip(x + y - 3, 0, None) * height
    light = np.round(1.3 * height - (x + y) / RADIUS + 0.28 * through, 6)
    # Every shade but the darkest as often as the others: the palette is what this picture is about.
    inside = far <= 1
    order = np.argsort(light[inside], kind="stable")
    level = np.zeros((CELL, CELL))
    shades = np.empty(order.size)
    shades[order] = 1 + np.arange(order.size) * (SHADES - 1) // order.size
    level[inside] = shades
    return level


def marbles():
    """Four rows of four."""
    y, x = np.mgrid[0:SIDE * CELL, 0:SIDE * CELL]
    picture = painted((y // CELL) * SIDE + x // CELL, np.tile(marble(), (SIDE, SIDE)))
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) == len(COLOURS), "a colour of the palette is missing"
    return picture
