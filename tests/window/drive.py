#!/usr/bin/python3
"""Drives the real window with xdotool: drags a vertex, steps, copies and pastes the state, quits.

usage: drive.py TEXELSCOPE     with DISPLAY set, as under xvfb-run

What the window did is read from the files that Ctrl+S writes; nothing is guessed from pixels or timed.
"""
import ctypes
import os
import select
import subprocess
import sys
import tempfile

LIMIT = 30  # seconds until something that must happen counts as failed
IN_MOVED_TO = 0x80


def xdotool(*arguments):
    return subprocess.run(["xdotool", *map(str, arguments)], check=True, capture_output=True, text=True, timeout=LIMIT).stdout


class SavedFiles:
    """Waits for files that are moved into a folder, which is how the program saves."""

    def __init__(self, folder):
        self.folder = folder
        self.libc = ctypes.CDLL(None, use_errno=True)
        self.watch = self.libc.inotify_init()
        self.libc.inotify_add_watch(self.watch, folder.encode(), IN_MOVED_TO)

    def next(self):
        ready, _, _ = select.select([self.watch], [], [], LIMIT)
        if not ready:
            raise SystemExit("FAILED: no file was saved")
        os.read(self.watch, 4096)
        names = [n for n in os.listdir(self.folder) if n.endswith(".texelscope")]
        with open(os.path.join(self.folder, names[0]), encoding="ascii") as file:
            return file.read().strip()


def field(link, key):
    return [part[2:] for part in link.split(";") if part.startswith(key + "=")]


def expect(what, condition, link):
    if not condition:
        raise SystemExit(f"FAILED: {what}\n  {link}")
    print("ok:", what)


def corner(link, x, y):
    """Whether the link moves vertex 0 of polygon 0 to about (x, y)."""
    for edit in field(link, "e"):
        numbers = edit.split(",")
        if numbers[:2] == ["0", "0"]:
            return abs(float(numbers[2]) - x) < 0.3 and abs(float(numbers[3]) - y) < 0.3
    return False


def main():
    with tempfile.TemporaryDirectory() as folder:
        program = subprocess.Popen([os.path.abspath(sys.argv[1]), "9"], cwd=folder)
        try:
            drive(program, SavedFiles(folder))
        finally:
            if program.poll() is None:
                program.kill()


def drive(program, saved):
    window = xdotool("search", "--sync", "--onlyvisible", "--name", "Texelscope").split()[0]
    xdotool("windowsize", "--sync", window, 1280, 720)
    xdotool("windowfocus", "--sync", window)

    def keys(*names):
        for name in names:
            xdotool("key", name)

    def saved_link():
        keys("ctrl+s")
        return saved.next()

    # Lesson 9's P0 stands at (3.5, 20.25): 20 window pixels a pixel, from (16, 56).
    def place(x, y):
        return 16 + 20 * x, 56 + 20 * y

    start = saved_link()
    expect("the window opens on lesson 9", "09-" in start and not field(start, "e"), start)
    xdotool("mousemove", "--window", window, *place(3.5, 20.25), "mousedown", 1)
    saved_link()  # by now the window has seen the press; a hand is never so quick that it had not
    for x, y in ((4, 20), (5, 19.5), (5.5, 19.25)):
        xdotool("mousemove", "--window", window, *place(x, y))
    saved_link()
    xdotool("mouseup", 1)
    dragged = saved_link()
    expect("a drag moves the vertex", corner(dragged, 5.5, 19.25), dragged)
    keys("Right", "Right", "Right")
    stepped = saved_link()
    expect("three presses of Right step on", field(stepped, "s") != field(dragged, "s"), stepped)
    keys("ctrl+c", "ctrl+z")
    undone = saved_link()
    expect("Ctrl+Z takes the drag back", not field(undone, "e"), undone)
    keys("ctrl+v")
    pasted = saved_link()
    expect("a pasted state is the copied one", pasted == stepped, pasted)
    keys("ctrl+q")
    expect("Ctrl+Q quits with exit code 0", program.wait(timeout=LIMIT) == 0, "")


if __name__ == "__main__":
    main()
