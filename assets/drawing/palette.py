"""The 256 colours most pictures are drawn with: sixteen ramps of sixteen shades, from dark to light.

The index of a colour is 16 * ramp + shade, so that a texel is lit by changing the low four bits alone.
"""
import numpy as np

SHADES = 16

# The colours a ramp goes through, evenly spaced. Dark shades lean to blue or red, light ones to yellow: as paint does.
STOPS = {
    "grey": "000000 2b2b2f 5a5a5e 8c8c8e c0c0c0 ffffff",
    "steel": "0b1016 1f2a38 3a4a5e 647890 9cb0c4 e6f0f8",
    "stone": "14110f 302a26 544c44 827668 b4a692 ece2cc",
    "brick": "180a0a 43171a 742a24 a34a36 cc7a5c f0bfa4",
    "wood": "150c08 38200f 613a1a 8e5c2c bd8a4c e8c88c",
    "skin": "24120e 5c3022 96583c c98660 ecb48c ffe6cc",
    "fire": "120204 5c0808 b41a06 f06010 fcc030 fffce0",
    "red": "1c0408 560a14 980f1c d82a2e f4706a ffc8c0",
    "gold": "1e1004 5a3406 9c6408 dc9a14 f8cc48 fff4b8",
    "grass": "0a1406 1e3a10 3a681c 64982c 9cc850 e2f4a4",
    "leaf": "04140e 0a3422 12583a 248456 5cb884 bcecc8",
    "sea": "041018 083448 0c6278 1c98a8 60ccd0 ccf8f0",
    "blue": "060a22 0e1e58 163c98 2c6cd8 6ca8f4 cce6ff",
    "violet": "10081e 2c1656 502c92 7e52cc b08cec e6d6ff",
    "rose": "1e0618 560e40 961e6c d44498 f484c0 ffd0e8",
    "sand": "261c10 5e4828 987c48 ccae70 ecd8a0 fffaec",
}
ROWS = {name: row for row, name in enumerate(STOPS)}


def rgb(text):
    """Three bytes from six hexadecimal digits."""
    return np.array([int(text[n:n + 2], 16) for n in (0, 2, 4)], np.int64)


def ramp(stops):
    """Sixteen shades through the stops, in whole numbers."""
    stops, last = [rgb(s) for s in stops.split()], SHADES - 1
    spans, shades = len(stops) - 1, []
    for shade in range(SHADES):
        span = min(shade * spans // last, spans - 1)
        part = shade * spans - span * last
        shades.append((stops[span] * (last - part) + stops[span + 1] * part + last // 2) // last)
    return np.array(shades, np.uint8)


COLOURS = np.concatenate([ramp(stops) for stops in STOPS.values()])
assert len(np.unique(COLOURS, axis=0)) == 256, "two entries of the palette are equal"

# Thresholds of a 4 x 4 ordered dither, in sixteenths.
BAYER = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]])


def colour(name, shade):
    """One colour of the palette."""
    return COLOURS[SHADES * ROWS[name] + shade].astype(np.int64)


def painted(name, level, dither=0.0):
    """The picture of a field of shades [0, 15] in one ramp, or for an array of rows in the ramp of each pixel.

    `dither` is how far, in shades, an ordered pattern may push a value: 0 for flat steps, 1 for an even mixture.
    """
    rows = ROWS[name] if isinstance(name, str) else name
    height, width = level.shape
    pattern = (np.tile(BAYER, (-(-height // 4), -(-width // 4)))[:height, :width] + 0.5) / 16 - 0.5
    settled = np.round(level + dither * pattern, 6)  # what the last bits of sin() say must not choose a colour
    shade = np.clip(np.floor(settled + 0.5), 0, SHADES - 1).astype(np.int64)
    return COLOURS[SHADES * rows + shade].copy()


def vga_1995():
    """The palette itself, one ramp a row."""
    return COLOURS.reshape(SHADES, SHADES, 3)
