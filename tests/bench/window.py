#!/usr/bin/python3
"""How soon the real window shows its first frame, and what it costs while nothing happens.

usage: xvfb-run -a tests/bench/window.py build/release/app/texelscope
"""
import os
import subprocess
import sys
import time

IDLE_SECONDS = 10


def processor_seconds(pid):
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    start = time.monotonic()
    program = subprocess.Popen([sys.argv[1], "9"])
    try:
        subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "The u v plane"], check=True, stdout=subprocess.DEVNULL, timeout=60)
        print(f"first frame after {time.monotonic() - start:.2f} s")
        time.sleep(2)
        before = processor_seconds(program.pid)
        time.sleep(IDLE_SECONDS)
        print(f"idle: {processor_seconds(program.pid) - before:.2f} s of processor time in {IDLE_SECONDS} s")
    finally:
        program.kill()


if __name__ == "__main__":
    main()
