"""PNG files with a palette, written and compared."""
import struct
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def palette_of(picture):
    """The colours of an RGB picture in the order of first appearance, and the index of each pixel."""
    height, width, _ = picture.shape
    keys = picture.astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], np.uint32)
    found, first, inverse = np.unique(keys.ravel(), return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    colours = np.stack([found >> 16, found >> 8 & 255, found & 255], axis=1).astype(np.uint8)[order]
    return colours, rank[inverse].reshape(height, width).astype(np.uint8)


def depth_for(colours):
    """The fewest bits a pixel that can name so many colours [1, 2, 4 or 8]."""
    assert colours <= 256, f"{colours} colours do not fit a palette"
    return next(bits for bits in (1, 2, 4, 8) if colours <= 1 << bits)


def packed(indices, depth):
    """Rows of `depth` bits a pixel, the first pixel in the high bits, each row after the byte of filter 0 (none)."""
    height, width = indices.shape
    per_byte = 8 // depth
    padded = np.zeros((height, -(-width // per_byte) * per_byte), np.uint8)
    padded[:, :width] = indices
    groups = padded.reshape(height, -1, per_byte) << (np.arange(per_byte)[::-1] * depth).astype(np.uint8)
    rows = np.bitwise_or.reduce(groups, axis=2).astype(np.uint8)
    return np.hstack([np.zeros((height, 1), np.uint8), rows]).tobytes()


def deflated(data):
    """The shortest of what the strategies of zlib yield."""
    def attempt(strategy):
        stream = zlib.compressobj(9, zlib.DEFLATED, 15, 9, strategy)
        return stream.compress(data) + stream.flush()
    return min((attempt(s) for s in (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FILTERED, zlib.Z_RLE)), key=len)


def chunk(kind, data):
    """Length, type, data, checksum."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def encode(picture):
    """The file of an RGB picture of at most 256 colours. Shape (height, width, 3), 8 bits a channel."""
    colours, indices = palette_of(picture)
    depth = depth_for(len(colours))
    height, width = indices.shape
    header = struct.pack(">IIBBBBB", width, height, depth, 3, 0, 0, 0)
    return (SIGNATURE + chunk(b"IHDR", header) + chunk(b"PLTE", colours.tobytes()) +
            chunk(b"IDAT", deflated(packed(indices, depth))) + chunk(b"IEND", b""))


def contents(file):
    """The chunks of a PNG, its pixels inflated: two versions of zlib may differ in the bytes, but not in these."""
    chunks, at, data = [], len(SIGNATURE), b""
    while at + 12 <= len(file):
        length, = struct.unpack_from(">I", file, at)
        kind, body = file[at + 4:at + 8], file[at + 8:at + 8 + length]
        if file[at:at + 12 + length] != chunk(kind, body):
            raise ValueError("damaged chunk")
        if kind == b"IDAT":
            data += body
        else:
            chunks.append((kind, body))
        at += 12 + length
    return file[:len(SIGNATURE)], chunks, zlib.decompress(data), file[at:]


def same(a, b):
    """Whether two PNG files say the same, chunk by chunk."""
    try:
        return a == b or contents(a) == contents(b)
    except (ValueError, struct.error, zlib.error):
        return False
