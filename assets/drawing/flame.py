"""Fire by the old cellular rule: a cell becomes the mean of those below it, a little cooler.

A row depends on the rows below it only. With fuel and cooling that repeat, the whole fire repeats exactly once the
first row's heat has passed the top: the last frame is followed by the first.
"""
import numpy as np

from drawing.noise import random_at
from drawing.palette import painted

SIZE = 32      # cells a side, and the texels of a frame
FRAMES = 10
STEPS = 3      # of the rule in a frame
PERIOD = FRAMES * STEPS
HOTTEST = 4096
COLUMNS = np.arange(SIZE)


def fuel(step):
    """The heat of the two rows below the picture: embers that flare and fade, hottest in the middle."""
    flicker = random_at(51, COLUMNS // 2, np.full(SIZE, step % PERIOD // 3))
    middle = 1 - np.abs(2 * COLUMNS + 1 - SIZE) / SIZE
    heat = np.minimum(1, 2.6 * middle) * (0.35 + 0.9 * flicker)
    return np.minimum(HOTTEST, (heat * HOTTEST).astype(np.int64))


def cooling(step):
    """What each cell loses: a field of cool and warm air that rises, and returns to its start after a period."""
    rows = (np.arange(SIZE)[:, None] + step) % PERIOD
    gust = random_at(52, rows // 3, (COLUMNS // 3)[None, :])
    side = np.abs(2 * COLUMNS + 1 - SIZE)[None, :] / SIZE
    return (HOTTEST * (0.008 + 0.062 * gust * gust + 0.035 * side * side)).astype(np.int64)


def next_heat(heat, step):
    """One step of the rule for the picture's rows and the two of fuel below it."""
    left, right = np.roll(heat, 1, axis=1), np.roll(heat, -1, axis=1)
    left[:, 0] = right[:, -1] = 0
    mean = (left[1:-1] + heat[1:-1] + right[1:-1] + heat[2:]) // 4
    return np.vstack([np.maximum(0, mean - cooling(step)), fuel(step), fuel(step)])


def flame():
    """Ten frames of 32 x 32, one below the other."""
    heat, frames = np.zeros((SIZE + 2, SIZE), np.int64), []
    for step in range(2 * PERIOD + PERIOD):
        heat = next_heat(heat, step)
        if step >= 2 * PERIOD and step % STEPS == 0:
            frames.append(heat[:SIZE])
    return shown(np.vstack(frames))


def shown(heat):
    """Colours of heat: black where there is none."""
    picture = painted("fire", heat * 17.0 / HOTTEST)
    picture[heat * 17 < HOTTEST] = 0
    return picture
