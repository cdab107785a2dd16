"""Time against the number of triangles: the same kinds of triangles, from 10^2 to 10^6 of them, against a cost a pixel
and a cost a triangle that fit them all; as a CSV and a picture, log-log."""
import csv
import math

import numpy as np

import triangles as tri

COUNTS = (100, 316, 1000, 3162, 10_000, 31_623, 100_000, 316_228, 1_000_000)
COLOURS = ("#c2410c", "#1d4ed8", "#15803d")
WIDTH, HEIGHT, LEFT, BOTTOM, EDGE = 720, 480, 64, 48, 36  # of the picture [px]


def make(folder, workloads):
    """For each workload its files, smallest first: its first triangles, all of them repeated where they are too few."""
    files = {}
    for name, path in workloads.items():
        whole = tri.read(path)
        for count in COUNTS:
            part = folder / f"{name}-{count}.tri"
            corners = np.tile(whole.corners, (-(-count // len(whole.corners)), 1, 1))[:count]
            tri.write(part, tri.Triangles(corners, whole.width, whole.height, whole.flags, whole.texture))
            files.setdefault(name, []).append(part)
    return files


def report(folder, files, racers):
    """Head and rows of a table; writes scaling.csv and scaling.svg."""
    names, counts, pixels, times = [], [], [], []
    for name, paths in files.items():
        for path, count in zip(paths, COUNTS):
            racer = racers[path.stem]
            names.append(name), counts.append(count), times.append(racer.least[path.stem])
            pixels.append(racer.rates[path.stem][0] * 1e3)
    work = np.array([pixels, counts], float).T
    # Weighted by 1 / time: each file's share of the error counts, not its milliseconds.
    cost, *_ = np.linalg.lstsq(work / np.array(times)[:, None], np.ones(len(times)), rcond=None)
    fit = work @ cost
    rows = list(zip(names, counts, (round(p) for p in pixels), times, fit))
    with open(folder / "scaling.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["workload", "triangles", "pixels", "ms", "ms of the fit"])
        writer.writerows((n, c, p, f"{t:.5f}", f"{f:.5f}") for n, c, p, t, f in rows)
    (folder / "scaling.svg").write_text(plot(rows, cost))
    head = ["workload", "triangles", "pixels", "ms, least", f"of {cost[0] * 1e6:.2f} ns a pixel + {cost[1] * 1e6:.1f} ns a triangle"]
    return head, [[n, f"{c}", f"{p}", f"{t:.4f}", f"x {t / f:.2f}"] for n, c, p, t, f in rows]


def plot(rows, cost):
    low_y, high_y = (f(math.log10(v) for row in rows for v in row[3:5]) for f in (min, max))
    low_y, high_y, low_x, high_x = math.floor(low_y), math.ceil(high_y), 2, 6

    def place(count, ms):
        x = LEFT + (math.log10(count) - low_x) / (high_x - low_x) * (WIDTH - LEFT - EDGE)
        return x, HEIGHT - BOTTOM - (math.log10(ms) - low_y) / (high_y - low_y) * (HEIGHT - BOTTOM - EDGE)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
             f'font-size="13"><rect width="100%" height="100%" fill="white"/>']
    for power in range(low_x, high_x + 1):
        x, y = place(10**power, 10**low_y)
        parts.append(f'<path d="M{x:.1f} {y}V{EDGE}" stroke="#ddd"/><text x="{x:.1f}" y="{y + 20}" text-anchor="middle">{10**power:,}</text>')
    for power in range(low_y, high_y + 1):
        x, y = place(10**low_x, 10**power)
        parts.append(f'<path d="M{x} {y:.1f}H{WIDTH - EDGE}" stroke="#ddd"/><text x="{x - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0**power:g}</text>')
    for n, name in enumerate(dict.fromkeys(row[0] for row in rows)):
        own = [row for row in rows if row[0] == name]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(row[1], row[4]) for row in own))
        parts.append(f'<polyline points="{line}" fill="none" stroke="{COLOURS[n]}"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{COLOURS[n]}"/>' for x, y in (place(row[1], row[3]) for row in own)]
        parts.append(f'<text x="{LEFT + 16}" y="{EDGE + 24 + 20 * n}" fill="{COLOURS[n]}">{name}</text>')
    parts.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 8}" text-anchor="middle">milliseconds for triangles; lines: {cost[0] * 1e6:.2f} ns a pixel '
                 f'+ {cost[1] * 1e6:.1f} ns a triangle</text></svg>')
    return "\n".join(parts)
