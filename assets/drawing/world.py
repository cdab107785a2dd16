"""The map of a world that does not exist: noise on a sphere, climate by latitude, in the equirectangular projection."""
import math

import numpy as np

from drawing.noise import layers
from drawing.palette import ROWS, painted

WIDTH, HEIGHT = 256, 128
LAND = 0.36  # of the sphere


def sphere():
    """The points of the map on the unit sphere, and the latitude [-1, 1]. The first column follows the last."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH] + 0.5
    latitude, longitude = math.pi * (0.5 - v / HEIGHT), 2 * math.pi * u / WIDTH
    ring = np.cos(latitude)
    return [ring * np.cos(longitude), ring * np.sin(longitude), np.sin(latitude)], latitude * 2 / math.pi


def elevation(points):
    """Heights with 0 at the shore: large continents, bent coasts."""
    bent = [p + 0.22 * layers([2.1 * q for q in points], 610 + n, 3) for n, p in enumerate(points)]
    height = layers([1.35 * p + 4.7 for p in bent], 67, 6, gain=0.52)
    weight = np.sqrt(1 - points[2]**2)
    order = np.argsort(height, axis=None)
    above = np.cumsum(weight.ravel()[order]) / weight.sum()
    return height - height.ravel()[order][np.searchsorted(above, 1 - LAND)]


def relief(height):
    """How much the light from the upper left meets a slope."""
    across = np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)
    down = np.gradient(height, axis=0) * 2
    return np.clip(22 * (across + down), -2.2, 2.2)


def sea(height, latitude):
    """Shades of water: light over the shelves, dark in the deep."""
    return 8.4 - 7.4 * np.sqrt(np.clip(-height, 0, 0.45)) - 0.8 * np.abs(latitude)


def climate(points, height, latitude):
    """Warmth and rain, each about [0, 1]: dry belts on both sides of a wet equator."""
    far = np.abs(latitude)
    warmth = 1.04 - 1.15 * far**1.5 - 0.75 * np.clip(height - 0.1, 0, 1) + 0.16 * layers([3 * p for p in points], 71, 3)
    belt = np.exp(-((far - 0.27) / 0.13)**2)
    rain = 0.62 - 0.42 * belt + 0.55 * layers([2.3 * p for p in points], 73, 4)
    return warmth, rain


def land(warmth, rain, height):
    """The ramp of each place and its middle shade, the first rule that fits."""
    rules = [
        (warmth < 0.14, "steel", 14.2),
        (height > 0.52, "grey", 12.5),
        (height > 0.36, "stone", 8.2),
        (warmth < 0.27, "stone", 10.0),
        (warmth < 0.43, "leaf", 5.6),
        (rain < 0.30, "sand", 10.2),
        (rain < 0.42, "sand", 8.4),
        (rain < 0.56, "grass", 9.0),
        ((rain > 0.70) & (warmth > 0.80), "leaf", 4.8),
        (rain > 0.68, "grass", 5.6),
        (rain == rain, "grass", 7.2),
    ]
    fits = [rule[0] for rule in rules]
    return np.select(fits, [ROWS[rule[1]] for rule in rules]), np.select(fits, [rule[2] for rule in rules])


def world():
    """Sea, ice, forests, deserts and mountains, lit from the upper left."""
    points, latitude = sphere()
    height = elevation(points)
    warmth, rain = climate(points, height, latitude)
    wet = height < 0
    frozen = wet & (warmth < 0.02)
    rows, level = land(warmth, rain, height)
    level = level + relief(height)
    surf = wet & (height > -0.022)
    rows = np.where(wet, np.where(surf, ROWS["sea"], ROWS["blue"]), rows)
    level = np.where(wet, np.where(surf, 9.0, sea(height, latitude)), level)
    rows, level = np.where(frozen, ROWS["steel"], rows), np.where(frozen, 13.0, level)
    return painted(rows, level, 0.7)
