#!/usr/bin/python3
"""Builds the rasterizer by each compiler without and with optimisation and compares the hashes of what it draws with
those in tests/core/fast/determinism_test.cpp. It takes some minutes, so it is run by hand; of the two builds that
tests/run makes, one is g++ -O3 and the other clang++ -O1, and both compare the same hashes.
--exact prints the hashes by the definition, as that file holds them."""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KNOWN = ROOT / "tests/core/fast/determinism_test.cpp"
SOURCES = [*sorted(ROOT.glob("core/fast/*.cpp")), ROOT / "core/exact/triangle.cpp", ROOT / "core/geometry/polygon.cpp",
           ROOT / "core/measure/workloads.cpp", ROOT / "tests/core/fast/determined_scenes.cpp",
           ROOT / "tests/determinism/hashes.cpp"]
# As cmake/Flags.cmake has them.
FLAGS = ["-std=c++20", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-DHWY_SHARED_DEFINE", f"-I{ROOT}"]


def built(compiler, level, folder):
    """The program that prints the hashes."""
    objects = []
    for source in SOURCES:
        objects.append(folder / (source.stem + ".o"))
        subprocess.run([compiler, *FLAGS, level, "-c", source, "-o", objects[-1]], check=True)
    program = folder / "hashes"
    subprocess.run([compiler, *objects, "-o", program, "-lhwy", "-ltbb"], check=True)
    return program


def hashes(program, *options):
    run = subprocess.run([program, *options], check=True, capture_output=True, text=True)
    return run.stdout.splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compilers", nargs="+", default=["g++", "clang++"])
    parser.add_argument("--levels", nargs="+", default=["0", "3"], help="of optimisation, as -O takes them")
    parser.add_argument("--exact", action="store_true")
    args = parser.parse_args()
    if args.exact:
        with tempfile.TemporaryDirectory() as folder:
            print("\n".join(hashes(built(args.compilers[0], "-O1", pathlib.Path(folder)), "--exact")))
        return 0
    known = re.findall(r'^ *(\{".*", 0x\w{16}\},)$', KNOWN.read_text(), re.M)
    faults = 0
    for compiler in args.compilers:
        for level in args.levels:
            start = time.monotonic()
            with tempfile.TemporaryDirectory() as folder:
                drawn = hashes(built(compiler, f"-O{level}", pathlib.Path(folder)))
            others = [line for line in drawn if line not in known]
            faults += len(others) + (len(drawn) != len(known))
            print(f"{compiler} -O{level}: {len(drawn) - len(others)} of {len(known)} hashes as known, {time.monotonic() - start:.0f} s")
            print("".join(f"  {line}\n" for line in others), end="", flush=True)
    return faults > 0


if __name__ == "__main__":
    sys.exit(main())
