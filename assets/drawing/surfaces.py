"""Walls, boards and floors. A surface is a field of shades, painted in a ramp at the end."""
import math

import numpy as np

from drawing.noise import layers, pick, random_at, tiling
from drawing.palette import ROWS, painted

SIZE = 64  # texels


def paste(picture, patch, top, left):
    """Puts a smaller picture or field into a larger one."""
    picture[top:top + patch.shape[0], left:left + patch.shape[1]] = patch


def bricks():
    """Eight courses in running bond, with mortar one texel wide; tiles."""
    y, x = np.mgrid[0:SIZE, 0:SIZE]
    course = y // 8
    along = (x + 8 * (course % 2)) % SIZE
    brick, bx, by = along // 16, along % 16, y % 8
    tone = random_at(11, course, brick)
    level = 7.6 + 3.4 * (tone - 0.5) + 2.2 * tiling((SIZE, SIZE), (16, 16), 12, 2) + 1.0 * (random_at(13, y, x) - 0.5)
    level += np.select([by == 0, by == 6], [1.8, -1.9], 0) + np.select([bx == 0, bx == 14], [0.9, -1.3], 0)
    level -= 2.6 * (random_at(14, y, x) > 0.975)

    corner = ((by == 0) | (by == 6)) & ((bx == 0) | (bx == 14))
    chipped = corner & (random_at(15, y, x) < 0.45)
    mortar = (by == 7) | (bx == 15) | chipped
    joint = 8.6 + 1.8 * tiling((SIZE, SIZE), (16, 16), 16, 2) + 0.8 * (random_at(17, y, x) - 0.5) - 2.2 * (by == 7)
    burnt = (tone > 0.93) & ~mortar
    rows = np.where(mortar, ROWS["stone"], ROWS["brick"])
    return painted(rows, np.where(mortar, joint, level - 3.2 * burnt))


def grain(height, width, seed, knots=(), period=SIZE):
    """Shades of a board that lies across, about 0: fibres, rings, knots at (y, x, radius). Repeats after `period`."""
    y, x = np.mgrid[0:height, 0:width] + 0.5
    cells = max(1, period // 32)
    sway = layers([y / 16, x * cells / period], seed, 2, (64, cells))
    rings, dark = y * 0.27 + 1.7 * sway, np.zeros((height, width))
    for ky, kx, radius in knots:
        dx = (x - kx + period / 2) % period - period / 2
        far = np.sqrt((dx / 2.1)**2 + (y - ky)**2) / radius
        rings = rings + 1.9 * np.exp(-far**2 / 2.2)
        dark = dark + 3.4 * np.exp(-(far * 1.5)**4)
    fibre = layers([y * 0.9, x * 2 * cells / period], seed + 5, 3, (64, 2 * cells))
    saw = rings - np.floor(rings)  # early wood is light, late wood ends in a dark line
    return 2.6 * (0.45 - saw * saw) + 1.9 * fibre - dark


def edged(level):
    """The board with a lit upper edge and a dark gap below."""
    level = level.copy()
    level[0] += 1.7
    level[-2] -= 1.4
    level[-1] = 1.6
    return level


def wood():
    """Four boards, each with one butt joint and its nails; tiles."""
    level = np.zeros((SIZE, SIZE))
    for board in range(4):
        joint = (int(64 * pick(21, board)) // 8 * 8 + 24 * board) % SIZE
        knot = (5 + 6 * pick(22, board), (joint + 14 + 34 * pick(23, board)) % SIZE, 1.6 + pick(24, board))
        tone = 8.6 + (0.7, -0.6, 0.2, -0.9)[board]
        strip = edged(tone + grain(16, SIZE, 260 + 31 * board, [knot] if board != 2 else []))
        strip[:-1, joint] = 2.4
        strip[:-1, (joint + 1) % SIZE] += 1.3
        for side in (-4, 4):
            for nail in (3, 11):
                strip[nail, (joint + side) % SIZE] = 2.6
                strip[nail + 1, (joint + side) % SIZE] += 1.5
        level[16 * board:16 * board + 16] = strip
    return painted("wood", level)


def plank(length, breadth, seed, tone, knots=()):
    """A board across with every edge bevelled, in shades."""
    level = tone + 0.85 * grain(breadth, length, seed, knots, 256)
    level[0] += 2.0
    level[:, 0] += 1.2
    level[-1] -= 2.6
    level[:, -1] -= 2.0
    return level


def crate_front():
    """The recessed upright boards of the crate with the shadow of its frame, in shades."""
    level = np.zeros((SIZE, SIZE))
    for n in range(4):
        paste(level, plank(48, 12, 310 + 17 * n, 6.3 + 0.9 * (pick(31, n) - 0.5)).T, 8, 8 + 12 * n)
    level[:, 19:SIZE:12] = 2
    level[8:11] -= np.array([[3.2], [2.2], [1.0]])
    level[:, 8:10] -= np.array([2.2, 1.0])
    return level


def add_brace(level):
    """The board from corner to corner, and the shadow under it."""
    y, x = np.mgrid[0:SIZE, 0:SIZE]
    across, along = x + y - (SIZE - 1), x - y + SIZE
    board = 0.85 * grain(10, SIZE + 1, 370, (), 256)  # a diagonal has half as many texels as sums
    face = 9.0 + board[np.clip((across + 9) // 2, 0, 9), along // 2]
    face += np.select([across <= -7, across >= 7], [1.8, -2.6], 0)
    level[(across > 8) & (across <= 12)] -= 2.4
    on = np.abs(across) <= 8
    level[on] = face[on]


def nail(picture, top, left):
    """A round head of two by two texels with its shadow."""
    paste(picture, painted("steel", np.array([[14.0, 10.0, 3.0], [10.0, 6.0, 2.0], [3.0, 2.0, 2.0]])), top, left)


def crate():
    """A wooden crate: four boards and a brace, framed and nailed."""
    level = crate_front()
    add_brace(level)
    for n, at in enumerate((0, SIZE - 9)):
        paste(level, plank(SIZE, 9, 330 + n, 9.4), at, 0)
    for n, at in enumerate((0, SIZE - 9)):
        paste(level, plank(SIZE - 18, 9, 350 + n, 8.9).T, 9, at)
    picture = painted("wood", level)
    for top in (3, SIZE - 6):
        for left in (3, 20, 41, SIZE - 6):
            nail(picture, top, left)
    for top in (20, 41):
        for left in (3, SIZE - 6):
            nail(picture, top, left)
    return picture


def crack(level, y, x, steps, seed):
    """A wandering dark line with a lit lower lip."""
    turn = 2 * math.pi * pick(seed, 0)
    for n in range(steps):
        turn += 1.5 * (pick(seed, 1, n) - 0.5)
        y, x = y + math.sin(turn), x + math.cos(turn)
        row, column = int(round(y, 6)) % SIZE, int(round(x, 6)) % SIZE
        level[row, column] = min(level[row, column], 4.2)
        level[(row + 1) % SIZE, column] += 0.7


def floor():
    """Worn stone slabs with cut corners, and a clay lozenge where four meet; tiles."""
    y, x = np.mgrid[0:SIZE, 0:SIZE]
    ty, tx = y % 32, x % 32
    slab_y, slab_x = y // 32, x // 32
    corner = np.minimum(ty, 32 - ty) + np.minimum(tx, 32 - tx)  # from the nearest joint
    tone = 8.4 + np.where((slab_y + slab_x) % 2, 0.9, -0.9)
    wear = 2.6 * tiling((SIZE, SIZE), (4, 4), 41, 4, 0.6) + 1.1 * (random_at(42, y, x) - 0.5)
    level = tone + wear
    level += np.select([(ty == 1) | (tx == 1), (ty == 31) | (tx == 31)], [1.9, -1.9], 0)
    level += np.where(corner == 9, np.select([(ty < 16) & (tx < 16), (ty > 16) & (tx > 16)], [1.6, -1.6], 0), 0)
    crack(level, 6, 40, 22, 43)
    crack(level, 50, 8, 17, 46)
    grout = (ty == 0) | (tx == 0) | (corner == 8)
    level[grout] = 3.0 + wear[grout] * 0.4
    clay = corner < 8
    # The upper half of a lozenge lies at the lower end of the slabs' rows.
    rim = np.where(corner == 7, np.where(ty > 16, 1.8, -1.8), 0)
    level = np.where(clay, 7.2 + 0.8 * wear + rim, level)
    return painted(np.where(clay, ROWS["brick"], ROWS["stone"]), level)
