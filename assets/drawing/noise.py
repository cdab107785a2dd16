"""Random numbers that are a function of a place, and smooth noise over them. The same everywhere and always."""
import itertools

import numpy as np

# Odd numbers out of the digits of pi.
MIX = (0x85A308D3, 0xA4093823, 0x299F31D1, 0xEC4E6C89)


def scramble(bits):
    """Spreads each bit of 32 over all of them."""
    bits = bits ^ bits >> np.uint32(16)
    bits = bits * np.uint32(MIX[0])
    bits = bits ^ bits >> np.uint32(13)
    bits = bits * np.uint32(MIX[1])
    return bits ^ bits >> np.uint32(16)


def random_at(seed, *place):
    """A number in [0, 1) for each place of whole coordinates."""
    place = np.broadcast_arrays(*[np.atleast_1d(np.asarray(p)) for p in place])
    bits = np.full(place[0].shape, seed, np.uint32)
    for axis in place:
        bits = scramble(bits * np.uint32(MIX[2]) + axis.astype(np.int64).astype(np.uint32) * np.uint32(MIX[3]))
    return bits / 2.0**32


def pick(seed, *place):
    """One number in [0, 1) for one place."""
    return float(random_at(seed, *place)[0])


def gradient_noise(points, seed, periods=None):
    """Smooth noise of about [-0.7, 0.7] at points given by one array an axis, repeating after `periods` where given."""
    cells = [np.floor(p) for p in points]
    inside = [p - c for p, c in zip(points, cells)]
    fade = [t * t * t * (t * (t * 6 - 15) + 10) for t in inside]
    total = 0
    for corner in itertools.product((0, 1), repeat=len(points)):
        place = [c + n for c, n in zip(cells, corner)]
        if periods:
            place = [p % period for p, period in zip(place, periods)]
        height, weight = 0, 1
        for axis, n in enumerate(corner):
            height = height + (2 * random_at(seed + 101 * axis, *place) - 1) * (inside[axis] - n)
            weight = weight * (fade[axis] if n else 1 - fade[axis])
        total = total + height * weight
    return total * 1.4


def layers(points, seed, octaves, periods=None, gain=0.5):
    """Noise in `octaves` sizes, each half as large and `gain` times as strong as the one before."""
    total, scale = 0, 1
    for octave in range(octaves):
        repeat = [p * scale for p in periods] if periods else None
        total = total + gain**octave * gradient_noise([p * scale for p in points], seed + 977 * octave, repeat)
        scale *= 2
    return total


def tiling(size, cells, seed, octaves=3, gain=0.5):
    """Noise over a picture of `size` = (height, width) in `cells` = (down, across); it goes on at the opposite side."""
    y, x = np.mgrid[0:size[0], 0:size[1]]
    points = [(y + 0.5) * cells[0] / size[0], (x + 0.5) * cells[1] / size[1]]
    return layers(points, seed, octaves, cells, gain)
