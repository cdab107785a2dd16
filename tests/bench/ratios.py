#!/usr/bin/python3
"""Times the fast rasterizer against its peers on the same triangles, one thread each, and prints tables in Markdown.
All racers draw in turns, round by round, so that what slows the machine for a while slows all of them; a ratio is the
median of the rounds' ratios. `unlike`: pixels of a peer's last picture that are not the fast rasterizer's, which is
exact. It measures and judges nothing. Build first: cmake --build --preset release. Allegro 4 is a peer where
liballegro4-dev was installed before."""
import argparse
import concurrent.futures
import os
import pathlib
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import scaling  # noqa: E402
import ties  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# How many times faster than llvmpipe the project wants to be: at least, and if it can.
WANTED = {"big": (5, 6.5), "hundred": (8.5, 12), "four": (14, 22), "mesh": (10, 16), "big-perspective": (3.8, 5),
          "hundred-perspective": (6.5, 9), "waste": (8.5, 15), "slivers": (11, 16)}
# Those whose triangles cover tiles that earlier ones were drawn in. llvmpipe leaves out such tiles of 64 x 64, too.
LAYERED = ("big", "big-perspective")
# The fast rasterizer with other options; shares are against the first.
SKIPS = ("off-screen", "no-sample", "zero-area", "back-face", "hidden", "hidden-tile", "early-z", "equal-w", "level-w",
         "zero-gradient", "one-texel", "level-z", "overdrawn")
VARIANTS = {
    "targets": {"best": [], "avx2": ["--target", "avx2"], "sse4": ["--target", "sse4"]},
    "threads": {"one": ["--threads", "1"], "two": ["--threads", "2"]},
    "certificates": {"certificates": [], "none": ["--no-certificates"]},
    "skips": {"all skips": [], "none": ["--skip=" + name + "=off" for name in SKIPS]},
}


class Racer:
    """A program that prints the line of `texelscope bench`, and what it said in each round."""

    def __init__(self, command, every=1):
        self.command, self.every = [str(word) for word in command], every
        self.medians, self.least, self.rates, self.fault = {}, {}, {}, None

    def run(self, number):
        if self.fault or number % self.every:
            return
        done = self.call()
        if self.fault:
            return
        for line in done.stdout.splitlines():
            _, _, stem, median, least, pixels, triangles = line.rsplit(",", 6)
            self.medians.setdefault(stem, {})[number] = float(median)
            self.least[stem] = min(self.least.get(stem, float("inf")), float(least))
            self.rates[stem] = (float(pixels) * float(median), float(triangles) * float(median))

    def call(self, *more):
        if not pathlib.Path(self.command[0]).exists():
            self.fault = f"{pathlib.Path(self.command[0]).name} is not built"
            return None
        done = subprocess.run([*self.command, *more], capture_output=True, text=True,
                              env={**os.environ, "LP_NUM_THREADS": "0", "OMP_NUM_THREADS": "1"})
        if done.returncode:
            self.fault = (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
        return done

    def ms(self, stem):
        return statistics.median(self.medians[stem].values()) if stem in self.medians else None

    def rate(self, stem):
        """Millions of pixels and of triangles a second, by the median."""
        return [work / self.ms(stem) for work in self.rates[stem]]


class Both(Racer):
    """Two programs at once, and what the slower one said: how much of two cores the machine gives."""

    def __init__(self, racer):
        super().__init__(racer.command)
        self.other = Racer(racer.command)

    def run(self, number):
        with concurrent.futures.ThreadPoolExecutor() as pool:
            pool.submit(self.other.run, number)
            super().run(number)
        self.fault = self.fault or self.other.fault
        for stem, medians in self.other.medians.items():
            if number in self.medians.get(stem, {}):
                self.medians[stem][number] = max(self.medians[stem][number], medians[number])


def race(racers, rounds):
    for number in range(rounds):
        for racer in racers if number % 2 == 0 else racers[::-1]:
            racer.run(number)
        print(".", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)


def ratio(slow, fast, slow_stem, fast_stem=None):
    """How many times longer `slow` takes: the median of the rounds' ratios, and the ratio of the least times."""
    a, b = slow.medians.get(slow_stem, {}), fast.medians.get(fast_stem or slow_stem, {})
    rounds = [a[n] / b[n] for n in a if n in b and b[n] > 0]
    if not rounds:
        return None, None
    return statistics.median(rounds), slow.least[slow_stem] / fast.least[fast_stem or slow_stem]


def text(value, form="{:.2f}"):
    return "–" if value is None else form.format(value)


def table(head, rows):
    print("\n| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


def faults(racers):
    for fault in sorted({racer.fault for racer in racers if racer.fault}):
        print(f"\nNot measured: {fault}")


class Bench:
    def __init__(self, options):
        self.options = options
        self.program = options.build / "app/texelscope"
        self.peers = options.build / "tests/bench"
        self.folder = options.build / "ratios"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.reps = str(options.reps)

    def workload(self, name, jitter=0):
        """The file; made anew where the program is younger."""
        path = self.folder / f"{name}{'-jittered' if jitter else ''}.tri"
        if not path.exists() or path.stat().st_mtime < self.program.stat().st_mtime:
            command = [self.program, "workload", name, "-o", path] + (["--jitter", str(jitter)] if jitter else [])
            subprocess.run([str(word) for word in command], check=True)
        return path

    def fast(self, files, more=()):
        return Racer([self.program, "bench", *files, "--reps", self.reps, *more])

    def llvmpipe(self, path):
        return Racer([self.peers / "texelscope_peer_llvmpipe", path, self.reps])

    def unlike(self, fast, peer):
        """The share of pixels that the peer's picture has otherwise [%]."""
        pictures = [str(self.folder / f"{who}.png") for who in ("fast", "peer")]
        if not shutil.which("compare"):  # ImageMagick
            return None
        fast.call("-o", pictures[0])
        peer.call(pictures[1])
        if fast.fault or peer.fault:
            return None
        size = subprocess.run(["identify", "-format", "%[fx:w*h]", pictures[0]], capture_output=True, text=True,
                              check=True)
        count = subprocess.run(["compare", "-metric", "AE", *pictures, "null:"], capture_output=True, text=True)
        return 100 * float(count.stderr) / float(size.stdout)

    def against_peers(self):
        rows, notes, all_racers = [], [], []
        for name in self.options.only:
            path = self.workload(name)
            fast, llvmpipe = self.fast([path]), self.llvmpipe(path)
            allegro = Racer([self.peers / "texelscope_peer_allegro", path, self.reps])
            racers = [fast, llvmpipe, allegro]
            overdrawing = self.fast([path], ["--skip=overdrawn=off"])
            if name in LAYERED:
                racers.append(overdrawing)
            if name == "big":
                bare = Racer([self.peers / "texelscope_peer_bare_loop", path, self.reps])
                numpy = Racer([ROOT / "tests/bench/peers/numpy_edges.py", path, 1], every=max(1, self.options.rounds // 3))
                racers += [bare, numpy]
            print(f"{name} ", end="", file=sys.stderr)
            race(racers, self.options.rounds)
            all_racers += racers
            times, by_least = ratio(llvmpipe, fast, name)
            must, aim = WANTED[name]
            rates = fast.rate(name) if fast.ms(name) else [None, None]
            rows.append([name, text(fast.ms(name), "{:.3f}"), text(rates[0], "{:.0f}"), text(rates[1]),
                         text(llvmpipe.ms(name), "{:.2f}"), text(times, "**{:.2f}**"), text(by_least), f"{must}", f"{aim}",
                         text(ratio(llvmpipe, overdrawing, name)[0]),
                         text(self.unlike(fast, llvmpipe), "{:.2f} %"), text(allegro.ms(name)),
                         text(ratio(allegro, fast, name)[0]), text(self.unlike(fast, allegro), "{:.2f} %")])
            if name == "big":
                for what, racer in {"": fast, ", all drawn": overdrawing}.items():
                    share, beside = ratio(bare, racer, name)[0], ratio(numpy, racer, name)[0]
                    notes.append(f"big{what}: {text(share and share * 100, '{:.0f}')} % of the bare loop's rate (must 70), "
                                 f"{text(beside, '{:.0f}')} times NumPy's (must 200)")
                notes.append(f"the bare loop takes {text(bare.ms(name), '{:.3f}')} ms, "
                             f"NumPy {text(numpy.ms(name), '{:.0f}')} ms")
        table(["workload", "fast ms", "Mpix/s", "Mtri/s", "llvmpipe ms", "ratio", "of least times", "must", "aim",
               "all drawn", "unlike", "Allegro ms", "ratio", "unlike"], rows)
        for note in notes:
            print("\n" + note)
        faults(all_racers)

    def variants(self, title, among):
        """Rates as shares of the first variant's; of targets the last against llvmpipe, too, of threads what two programs
        side by side get of the machine's cores."""
        first, *others = among
        heads = [f"rate with {other}" for other in others]
        heads += {"targets": ["sse4 against llvmpipe"], "threads": ["two programs at once"]}.get(title, [])
        rows, all_racers = [], []
        for name in self.options.only:
            path = self.workload(name)
            racers = [self.fast([path], more) for more in among.values()]
            raced = [(racers[0], other, 1) for other in racers[1:]]
            if title == "targets":
                raced.append((self.llvmpipe(path), racers[-1], 1))
            elif title == "threads":
                raced.append((racers[0], Both(racers[0]), 2))
            racers += [racer for pair in raced for racer in pair[:2] if racer not in racers]
            print(f"{title}, {name} ", end="", file=sys.stderr)
            race(racers, self.options.rounds)
            all_racers += racers
            rows.append([name, text(racers[0].ms(name), "{:.3f}")] +
                        [text(value and value * programs, "x {:.2f}") for slow, fast, programs in raced
                         for value in ratio(slow, fast, name)])
        table(["workload", f"{first}, ms"] + [word for head in heads for word in (head, "of least times")], rows)
        faults(all_racers)

    def pairs(self, title, head, files):
        """Each pair is drawn by one program, in turns: the second's time over the first's."""
        rows, all_racers = [], []
        for plain, other in files:
            racer = self.fast([plain, other])
            print(f"{title}, {other.stem} ", end="", file=sys.stderr)
            race([racer], self.options.rounds)
            all_racers.append(racer)
            times, by_least = ratio(racer, racer, other.stem, plain.stem)
            rows.append([other.stem, text(racer.ms(plain.stem), "{:.3f}"), text(racer.ms(other.stem), "{:.3f}"),
                         text(times, "x {:.2f}"), text(by_least, "x {:.2f}")])
        table(head, rows)
        faults(all_racers)

    def jittered(self):
        self.pairs("jitter", ["workload", "plain ms", "jittered by 0.03 px, ms", "time", "of least times"],
                   [(self.workload(name), self.workload(name, 0.03)) for name in self.options.only])

    def tied(self):
        self.pairs("ties", ["shapes", "without ties ms", "with ties ms", "time", "of least times"],
                   ties.make(self.folder))

    def scaled(self):
        """Each file in a program of its own: after a million triangles a hundred would be drawn with cold caches."""
        files = scaling.make(self.folder, {name: self.workload(name) for name in ("hundred", "four")})
        racers = {path.stem: Racer([self.program, "bench", path]) for paths in files.values() for path in paths}
        print("scaling ", end="", file=sys.stderr)
        race(list(racers.values()), min(self.options.rounds, 3))
        faults(racers.values())
        if not any(racer.fault for racer in racers.values()):
            table(*scaling.report(self.folder, files, racers))
            print(f"\n{self.folder / 'scaling.csv'}, {self.folder / 'scaling.svg'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--only", default=",".join(WANTED), help="workloads, separated by commas")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--reps", type=int, default=7, help="drawings a round")
    for name, what in {"targets": "shares of the instruction sets", "threads": "two threads against one",
                       "jitter": "corners moved by 0.03 px against plain ones", "ties": "ties against none",
                       "certificates": "nothing decided again", "skips": "no work left out",
                       "scaling": "time from 10^2 to 10^6 triangles"}.items():
        parser.add_argument(f"--{name}", action="store_true", help=what + ", instead of the peers")
    options = parser.parse_args()
    options.only = options.only.split(",")
    if unknown := [name for name in options.only if name not in WANTED]:
        parser.error(f"no workload {unknown[0]}, expected some of {', '.join(WANTED)}")
    bench = Bench(options)
    chosen = [name for name in VARIANTS if getattr(options, name)]
    for name in chosen:
        bench.variants(name, VARIANTS[name])
    for wanted, measure in ((options.jitter, bench.jittered), (options.ties, bench.tied), (options.scaling, bench.scaled)):
        if wanted:
            measure()
    if not chosen and not (options.jitter or options.ties or options.scaling):
        bench.against_peers()


if __name__ == "__main__":
    main()
