"""Letters of our own: small ones as rows of dots, large ones as strokes."""
import math

import numpy as np

# Five dots wide, seven high.
SMALL = {
    "A": ".###. #...# #...# ##### #...# #...# #...#", "B": "####. #...# #...# ####. #...# #...# ####.",
    "C": ".#### #.... #.... #.... #.... #.... .####", "D": "####. #...# #...# #...# #...# #...# ####.",
    "E": "##### #.... #.... ####. #.... #.... #####", "F": "##### #.... #.... ####. #.... #.... #....",
    "G": ".#### #.... #.... #..## #...# #...# .####", "H": "#...# #...# #...# ##### #...# #...# #...#",
    "1": "..#.. .##.. #.#.. ..#.. ..#.. ..#.. #####", "2": "####. ....# ....# .###. #.... #.... #####",
    "3": "####. ....# ....# .###. ....# ....# ####.", "4": "#...# #...# #...# ##### ....# ....# ....#",
    "5": "##### #.... #.... ####. ....# ....# ####.", "6": ".###. #.... #.... ####. #...# #...# .###.",
    "7": "##### ....# ....# ...#. ..#.. ..#.. ..#..", "8": ".###. #...# #...# .###. #...# #...# .###.",
    "u": "..... ..... #...# #...# #...# #..## .##.#", "v": "..... ..... #...# #...# #...# .#.#. ..#..",
}

# Eight dots wide and high, two to a stroke.
BOLD = {
    "A": "..####.. .######. ##....## ##....## ######## ######## ##....## ##....##",
    "B": "######.. #######. ##...##. ######.. #######. ##....## ######## #######.",
    "C": "..###### .####### ##...... ##...... ##...... ##...... .####### ..######",
    "D": "######.. #######. ##...### ##....## ##....## ##...### #######. ######..",
}


def dots(rows):
    """The mask of a glyph written in rows."""
    return np.array([[c == "#" for c in row] for row in rows.split()])


def arc(cx, cy, rx, ry, first, last, parts=12):
    """Points on an ellipse; angles in quarter turns from the right, clockwise on the picture."""
    turns = [(first + (last - first) * n / parts) * math.pi / 2 for n in range(parts + 1)]
    return [(cx + rx * math.cos(t), cy + ry * math.sin(t)) for t in turns]


# Middle lines of the strokes in a box of 1 by 1, y down, each a run of points. What leaves the letter's box is cut off.
STROKES = {
    "A": [[(0.46, -0.45), (-0.06, 1.45)], [(0.54, -0.45), (1.06, 1.45)], [(0.25, 0.68), (0.75, 0.68)]],
    "D": [[(0, 0), (0, 1)], [(0, 0), (0.5, 0), *arc(0.5, 0.5, 0.5, 0.5, -1, 1), (0, 1)]],
    "E": [[(0, 0), (0, 1)], [(0, 0), (1, 0)], [(0, 0.5), (0.86, 0.5)], [(0, 1), (1, 1)]],
    "G": [[(1, 0), *arc(0.5, 0.5, 0.5, 0.5, -1, -3), (1, 1)], [(1, 1), (1, 0.54)], [(0.62, 0.54), (1, 0.54)]],
    "I": [[(0.5, 0), (0.5, 1)]],
    "L": [[(0, 0), (0, 1)], [(0, 1), (1, 1)]],
    "N": [[(0, 1), (0, 0)], [(0, 0), (1, 1)], [(1, 1), (1, 0)]],
    "P": [[(0, 0), (0, 1)], [(0, 0), (0.62, 0), *arc(0.62, 0.29, 0.38, 0.29, -1, 1), (0, 0.58)]],
    "S": [[(1, 0), *arc(0.3, 0.25, 0.3, 0.25, -1, -3), *arc(0.7, 0.75, 0.3, 0.25, -1, 1), (0, 1)]],
    "T": [[(0, 0), (1, 0)], [(0.5, 0), (0.5, 1)]],
    "X": [[(-0.2, -0.45), (1.2, 1.45)], [(1.2, -0.45), (-0.2, 1.45)]],
}
NARROW = {"I": 0.0, "L": 0.86}  # of the usual width of the middle lines


def stroke_distance(x, y, a, b, square):
    """How far each point lies from the segment, in the norm that gives a stroke square ends or round ones."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.sqrt(dx * dx + dy * dy)
    along = ((x - a[0]) * dx + (y - a[1]) * dy) / length
    across = ((x - a[0]) * dy - (y - a[1]) * dx) / length
    beyond = np.abs(along - length / 2) - length / 2
    return np.maximum(np.abs(across), beyond) if square else np.sqrt(across**2 + np.maximum(beyond, 0)**2)


def run_distance(x, y, run):
    """How far each point lies from a run of segments: its two ends are square, what joins the segments is round."""
    run = [p for n, p in enumerate(run) if n == 0 or math.dist(p, run[n - 1]) > 1e-6]
    if len(run) == 2:
        return stroke_distance(x, y, *run, True)
    parts = [stroke_distance(x, y, a, b, False) for a, b in zip(run, run[1:])]
    for end, next_to in ((run[0], run[1]), (run[-1], run[-2])):
        stub = [e + (n - e) / 64 for e, n in zip(end, next_to)]
        parts.append(stroke_distance(x, y, end, stub, True))
    return np.minimum.reduce(parts)


def letter_distance(x, y, letter, left, top, width, height, half):
    """How far outside the letter each point is [px]; negative inside. The letter stays within its box."""
    w, h = (width - 2 * half) * NARROW.get(letter, 1), height - 2 * half
    runs = [[(left + half + w * px, top + half + h * py) for px, py in run] for run in STROKES[letter]]
    near = np.minimum.reduce([run_distance(x, y, run) for run in runs]) - half
    return np.maximum.reduce([near, np.abs(y - top - height / 2) - height / 2,
                              np.abs(x - left - half - w / 2) - half - w / 2])


def word_distance(x, y, word, centre, height, width, half, gap, grid=1):
    """How far outside the word each point is [px]. Sizes are those of a letter, `gap` lies between two.

    Every letter begins at a multiple of `grid` pixels.
    """
    widths = [round((2 * half + (width - 2 * half) * NARROW.get(letter, 1)) / grid) * grid for letter in word]
    left = (centre[0] - (sum(widths) + gap * (len(word) - 1)) / 2) // grid * grid
    near = np.full(x.shape, 1e9)
    for letter, used in zip(word, widths):
        near = np.minimum(near, letter_distance(x, y, letter, left, centre[1] - height / 2, width, height, half))
        left += used + gap
    return near
