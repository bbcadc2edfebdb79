#!/usr/bin/env python3
"""Every item of the Export menu, run by a script: what it writes is what `raytree` writes. Needs a
display, such as Xvfb's."""

import argparse
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

PIXEL = "210,286"
TREES = {"export.tree_json": ("tree.json", []), "export.tree_with_scene": ("whole.json",
                                                                          ["--embed-scene"]),
         "export.tree_text": ("tree.txt", []), "export.tree_dot": ("tree.dot", []),
         "export.tree_svg": ("tree.svg", []), "export.tree_vtp": ("tree.vtp", [])}

failures = []


def check(name, good, text=""):
    if not good:
        failures.append(name)
        print(f"FAILED  {name}: {text}", flush=True)


def check_same(name, ours, theirs):
    if not (ours.exists() and theirs.exists()):
        check(name, False, f"{ours if theirs.exists() else theirs} has not been written")
        return
    check(name, ours.read_bytes() == theirs.read_bytes(), f"{ours} is not {theirs}")


def png_size(path):
    return struct.unpack(">II", path.read_bytes()[16:24]) if path.exists() else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--inspector", required=True)
    parser.add_argument("--raytree", required=True)
    parser.add_argument("--scene", required=True)
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory() as name:
        ours, theirs = Path(name, "inspector"), Path(name, "raytree")
        ours.mkdir()
        theirs.mkdir()
        lines = [f"{command} {ours / file}" for command, (file, _) in TREES.items()]
        lines += [f"export.picture {ours / f}" for f in ("p.png", "p.ppm", "p.pfm")]
        lines += [f"export.scene {ours / f}" for f in ("s.json", "s.nff", "s.txt")]
        lines += [f"export.view {ours / 'view.png'} 1000x700", f"export.window {ours / 'w.png'}",
                  "copy.view", "copy.window", "file.quit"]
        script = Path(name, "script")
        script.write_text("\n".join(lines) + "\n")
        done = subprocess.run([arguments.inspector, arguments.scene, "--pixel", PIXEL, "--script",
                               script, "--size", "1280x800"], capture_output=True, text=True,
                              timeout=120)
        check("the script runs to its end", done.returncode == 0, done.stderr)

        def raytree(*words):
            subprocess.run([arguments.raytree, *words], check=True, capture_output=True)

        for command, (file, options) in TREES.items():
            raytree("trace", arguments.scene, "--pixel", PIXEL, "-o", theirs / file, *options)
            check_same(command, ours / file, theirs / file)
        for file in ("p.png", "p.ppm", "p.pfm"):
            raytree("render", arguments.scene, "-o", theirs / file)
            check_same(f"export.picture {file}", ours / file, theirs / file)
        for file in ("s.json", "s.nff", "s.txt"):
            raytree("convert", arguments.scene, theirs / file)
            check_same(f"export.scene {file}", ours / file, theirs / file)
        check("export.view", png_size(ours / "view.png") == (1000, 700),
              str(png_size(ours / "view.png")))
        check("export.window", png_size(ours / "w.png") == (1280, 800),
              str(png_size(ours / "w.png")))
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
