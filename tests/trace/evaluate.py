"""Evaluates what `texelscope trace` prints again, in every number format: both texts must give the value."""
import argparse
import json
import random
import subprocess
import sys

import numpy as np

from expressions import Evaluator
from number_formats import FORMATS

WIDTH, HEIGHT = 40, 30


def single(x):
    return float(np.float32(x))


def scene(rng):
    corners = []
    x0, y0 = rng.uniform(-6, 20), rng.uniform(-6, 15)
    grid = rng.choice([None, 1, 2, 4])
    for dx, dy in ((0, 0), (1, rng.uniform(-0.2, 0.3)), (1.1, 1), (rng.uniform(-0.2, 0.3), 1.05)):
        x, y = x0 + dx * 22, y0 + dy * 18
        if grid:
            x, y = round(x * grid) / grid, round(y * grid) / grid
        u, v = rng.uniform(-40, 90), rng.uniform(-40, 90)
        corners.append({"x": single(x), "y": single(y), "u": single(u), "v": single(v)})
    if rng.random() < 0.5:
        corners.reverse()
    texture = {"name": "t", "pattern": "uv", "size": [32, 64], "wrap": rng.choice(["repeat", "mask", "clamp"])}
    return {
        "texelscope": 1,
        "framebuffer": {"width": WIDTH, "height": HEIGHT},
        "textures": [texture],
        "polygons": [{"texture": "t", "light": single(rng.choice([1, 0.3, 1.7])), "vertices": corners}],
    }


class Checker:
    """Follows one trace: what each name last stood for, and whether every expression gives its value."""

    def __init__(self, fmt):
        self.fmt, self.known, self.shape = fmt, {}, None

    def typed(self, value, kind):
        if kind == "truth":
            return value is True
        return int(value) if kind == "integer" else self.fmt.from_text(value)

    def same(self, value, step):
        wanted = self.typed(step["value"], step["type"])
        if step["type"] != "real":
            return isinstance(value, bool) == isinstance(wanted, bool) and value == wanted
        return self.fmt.same(self.fmt.from_integer(value) if isinstance(value, int) else value, wanted)

    def evaluate(self, text, operands, with_names):
        rest = iter(operands)

        def leaf(word):
            operand = next(rest)
            if with_names and "name" in operand:
                if word != operand["name"]:
                    raise ValueError(f"'{word}' stands where the operand is {operand['name']}")
                value = self.known[word]
                if value != operand["value"]:
                    raise ValueError(f"{word} was {value} last, and {operand['value']} here")
            else:
                value = operand["value"]
                if word != (str(value).lower() if isinstance(value, bool) else value):
                    raise ValueError(f"'{word}' stands where the operand is {value}")
            return self.typed(value, operand["type"])

        value = Evaluator(self.fmt, leaf).value(text)
        if next(rest, None) is not None:
            raise ValueError("there are more operands than the text has")
        return value

    def step(self, step):
        parts = step["path"].split("/")
        if parts[0] != self.shape:
            self.shape, self.known = parts[0], {}
        for part in parts[2:]:
            if part[0] != "e":
                self.known[part[0]] = part[1:]
        if step["level"] != "expression":
            return []
        faults = []
        for key, with_names in (("substituted", False), ("formula", True)):
            try:
                value = self.evaluate(step[key], step["operands"], with_names)
                if not self.same(value, step):
                    faults.append(f"{key} gives {getattr(value, 'units', value)}")
            except (ValueError, KeyError, IndexError) as error:
                faults.append(f"{key}: {error!r}")
        self.known[step["name"]] = step["value"]
        return faults


def trace(program, text, options):
    run = subprocess.run([program, "trace", "-"] + options, input=text, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"the program failed: {run.stderr}")
    return [json.loads(line, parse_float=str, parse_int=str) for line in run.stdout.splitlines()]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--texelscope", required=True)
    parser.add_argument("--seed", type=int, default=1995)
    parser.add_argument("--count", type=int, default=4, help="how many scenes")
    args = parser.parse_args()
    print(f"seed {args.seed}, {args.count} scenes")
    rng = random.Random(args.seed)
    np.seterr(all="ignore")
    ways = [
        ["--method", method, "--variant", variant] + extra
        for method, extras in (("edge-equations", ([], ["--quirk", "arrays=on"])), ("sections", ([],)))
        for variant in ("corrected", "as-printed")
        for extra in extras
    ] + [["--variant", "as-published"], ["--method", "barycentric"], ["--method", "backward-projective"]]
    expressions = faults = 0
    seen = set()
    for _ in range(args.count):
        text = json.dumps(scene(rng))
        for number in FORMATS:
            for way in ways:
                pixels = [["--pixel", f"{rng.randrange(6, 30)},{rng.randrange(4, 24)}"] for _ in range(3)]
                for pixel in pixels:
                    options = way + ["--number", number] + pixel
                    checker = Checker(FORMATS[number])
                    for step in trace(args.texelscope, text, options):
                        expressions += step["level"] == "expression"
                        seen.add(step.get("fate"))
                        for fault in checker.step(step):
                            faults += 1
                            if faults <= 5:
                                print(f"{' '.join(options)}: {text}\n  {step}\n  {fault}")
    print(f"{expressions} expressions, {faults} faults; fates: {', '.join(sorted(filter(None, seen)))}")
    if expressions < 100 * args.count or "written" not in seen:
        sys.exit("too little was drawn to check")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main())
