#!/usr/bin/env python3
"""Uses raytree-inspector from outside as a hand does, with xdotool: clicks a pixel, presses keys,
exports the tree, and looks into the file for the pixel. Needs a display, such as Xvfb's."""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SKIPPED = 77
PATIENCE = 60  # seconds for whatever the window is asked for


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True,
                          timeout=PATIENCE)


def wait_for(what, found):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        result = found()
        if result:
            return result
        time.sleep(0.1)
    sys.exit(f"FAILED: waited in vain for {what}")


def windows(title):
    return xdotool("search", "--onlyvisible", "--name", title).stdout.split()


def key(*keys):
    xdotool("key", "--clearmodifiers", *keys)
    time.sleep(0.3)


def focus(window):
    """Without a window manager nobody gives the keys back to a window when its dialog closes."""
    xdotool("windowfocus", "--sync", window)
    time.sleep(1)


def exported_tree(window, folder, name):
    """Exports the tree by keys alone, and reads the file."""
    path = folder / name
    focus(window)
    key("ctrl+e")
    focus(wait_for("the dialog", lambda: windows("Tree as JSON"))[0])
    key("ctrl+a")
    xdotool("type", "--delay", "20", str(path))
    key("Return")
    wait_for(name, path.exists)
    focus(window)
    return json.loads(path.read_text())


def use(folder):
    window = wait_for("the window", lambda: windows("raytree inspector"))[0]
    time.sleep(2)  # the picture comes in
    xdotool("windowsize", "--sync", window, 1280, 800)
    xdotool("windowmove", "--sync", window, 0, 0)
    first = exported_tree(window, folder, "first.json")
    xdotool("mousemove", 150, 250, "click", 1)  # in the picture, at its upper left
    time.sleep(1)
    clicked = exported_tree(window, folder, "clicked.json")
    assert clicked["pixel"] != first["pixel"], (first["pixel"], clicked["pixel"])
    xdotool("mousemove", 150, 250, "click", 1)
    key("Right", "Right", "Right", "Down")
    time.sleep(0.5)
    moved = exported_tree(window, folder, "moved.json")
    i, j = clicked["pixel"]
    assert moved["pixel"] == [i + 3, j + 1], (clicked["pixel"], moved["pixel"])
    assert moved["rays"], "no rays"
    key("n", "h", "2", "f", "t")  # a ray, its object, from the side, fitted, in the dark
    key("alt+Left")
    back = exported_tree(window, folder, "back.json")
    assert back["pixel"] != moved["pixel"], back["pixel"]
    key("ctrl+q")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--inspector", required=True)
    parser.add_argument("--scene", required=True)
    options = parser.parse_args()
    if not shutil.which("xdotool"):
        print("skipped: xdotool is missing")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        environment = dict(os.environ, HOME=name)
        process = subprocess.Popen([options.inspector, options.scene, "--pixel", "320,240"],
                                   env=environment)
        try:
            use(Path(name))
            status = process.wait(timeout=PATIENCE)
        finally:
            process.kill()
    print("passed" if status == 0 else f"FAILED: exit status {status}")
    return status


if __name__ == "__main__":
    sys.exit(main())
