"""PNG files of 8 bits a channel, red, green, blue: read, and compared with a picture."""
import struct
import zlib

import numpy as np


def lines_of(file):
    """Width, and the lines of the file: the number of a filter, then the filtered bytes."""
    at, data = 8, b""
    while at < len(file):
        length, kind = struct.unpack_from(">I4s", file, at)
        body = file[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack_from(">IIBB", body)
            assert (depth, colour) == (8, 2), "not 8 bits of red, green and blue"
        data += body if kind == b"IDAT" else b""
        at += length + 12
    return width, np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + 3 * width)


def nearest(a, b, c):
    """Paeth: whichever of the three is nearest to a + b - c."""
    to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    return np.where((to_a <= to_b) & (to_a <= to_c), a, np.where(to_b <= to_c, b, c))


def decoded(file):
    """The pixels of the file."""
    width, lines = lines_of(file)
    picture = np.zeros((len(lines) + 1, width + 1, 3), int)  # with a row and a column of zeros before the first
    for y, line in enumerate(lines, 1):
        filtered, row, above = line[1:].reshape(width, 3).astype(int), picture[y], picture[y - 1]
        if line[0] == 0 or line[0] == 2:
            row[1:] = filtered + (above[1:] if line[0] == 2 else 0)
        elif line[0] == 1:
            row[1:] = np.cumsum(filtered, axis=0)
        for x in range(1, width + 1) if line[0] > 2 else ():
            a, b = row[x - 1], above[x]
            row[x] = (filtered[x - 1] + ((a + b) // 2 if line[0] == 3 else nearest(a, b, above[x - 1]))) & 255
        row &= 255
    return picture[1:, 1:].astype(np.uint8)


def shows(file, picture):
    """Whether the file holds this picture: filtered line by line as the file is, which needs no loop over pixels."""
    width, lines = lines_of(file)
    if picture.shape != (len(lines), width, 3):
        return False
    whole = np.zeros((len(lines) + 1, width + 1, 3), int)
    whole[1:, 1:] = picture
    for y, line in enumerate(lines, 1):
        now, a, b, c = whole[y, 1:], whole[y, :-1], whole[y - 1, 1:], whole[y - 1, :-1]
        guess = (0, a, b, (a + b) // 2, nearest(a, b, c))[line[0]]
        if not np.array_equal((now - guess) & 255, line[1:].reshape(width, 3)):
            return False
    return True


def differing(file, picture):
    """How many pixels of the file differ from those of the picture."""
    return 0 if shows(file, picture) else int(np.any(decoded(file) != picture, axis=2).sum())
