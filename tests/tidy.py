#!/usr/bin/python3
"""Runs clang-tidy over the program's sources. A file that passed is not read again until it, or anything that it
includes, changes."""
import argparse
import hashlib
import json
import pathlib
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

GCC_ONLY = {"-Wno-restrict", "-Wno-stringop-overflow", "-Wno-array-bounds"}
ROOT = pathlib.Path(__file__).resolve().parent.parent


def is_own(file, build):
    """One of the program's sources, or what CMake made of several of them. Those that only instantiate the methods
    once more (core/method/*_recorded.cpp) say nothing that the methods' other files do not."""
    if "texelscope_recorded.dir" in file.parts:
        return False
    made = file.name.startswith("unity_")
    return any(file.is_relative_to((build if made else ROOT) / folder) for folder in ("core", "app"))


def commands(build):
    """The compile commands of the program's own files, without what only gcc and ccache understand."""
    kept = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        if not is_own(file, build.resolve()):
            continue
        words = [w for w in shlex.split(entry["command"]) if not w.endswith("ccache") and w not in GCC_ONLY]
        words[0] = "clang++"
        kept.append({"directory": entry["directory"], "file": str(file), "arguments": words})
    return kept


def preprocessed(entry):
    words = [w for w in entry["arguments"] if w != "-c"]
    if "-o" in words:
        del words[words.index("-o") : words.index("-o") + 2]
    run = subprocess.run(words + ["-E"], cwd=entry["directory"], capture_output=True)
    return run.stdout


def check(entry, passed, folder, rules):
    key = hashlib.sha256(rules + preprocessed(entry)).hexdigest()
    if key in passed:
        return key, True, ""
    run = subprocess.run(["clang-tidy", "--quiet", "-p", str(folder), entry["file"]], capture_output=True, text=True)
    return key, run.returncode == 0, run.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build folder, for its compile commands")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    folder = args.build / "tidy"
    folder.mkdir(parents=True, exist_ok=True)
    entries = commands(args.build)
    (folder / "compile_commands.json").write_text(json.dumps(entries))
    memory = folder / "passed"
    before = set(memory.read_text().split()) if memory.exists() else set()
    rules = (ROOT / ".clang-tidy").read_bytes()
    with ThreadPoolExecutor(args.jobs) as pool:
        results = list(pool.map(lambda entry: check(entry, before, folder, rules), entries))
    for _, good, text in results:
        if not good:
            print(text.replace(str(ROOT) + "/", ""))
    good = {key for key, is_good, _ in results if is_good}
    memory.write_text("\n".join(sorted(good)))
    print(f"{len(entries)} files, {len(good & before)} unchanged since they passed, {len(entries) - len(good)} with findings")
    return len(good) < len(entries)


if __name__ == "__main__":
    sys.exit(main())
