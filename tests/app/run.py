#!/usr/bin/env python3
"""Runs raytree-inspector from outside: what it answers and refuses, and what its screenshots
consist of. Needs a display, such as Xvfb's."""

import argparse
import ctypes
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

RAYS = {"light": {"primary": 0x2B3440, "reflected": 0xE07B00, "refracted": 0x0B84C6,
                  "lit": 0xB59A1E, "selection": 0xD6336C},
        "dark": {"primary": 0xE8EEF5, "reflected": 0xFF9F38, "refracted": 0x45B5F5,
                 "lit": 0xE6D15C, "selection": 0xFF5C98}}

failures = []


def check(name, good, text=""):
    if not good:
        failures.append(name)
        print(f"FAILED  {name}: {text}", flush=True)


class PngImage(ctypes.Structure):
    """png_image of libpng's simplified interface."""
    _fields_ = [("opaque", ctypes.c_void_p), ("version", ctypes.c_uint32),
                ("width", ctypes.c_uint32), ("height", ctypes.c_uint32),
                ("format", ctypes.c_uint32), ("flags", ctypes.c_uint32),
                ("colormap_entries", ctypes.c_uint32),
                ("warning_or_error", ctypes.c_uint32), ("message", ctypes.c_char * 64)]


LIBPNG = ctypes.CDLL("libpng16.so.16")
PNG_VERSION, FORMAT_RGB = 1, 2


class Picture:
    """An 8-bit RGB picture."""

    def __init__(self, path):
        image = PngImage(version=PNG_VERSION)
        good = LIBPNG.png_image_begin_read_from_file(ctypes.byref(image), os.fsencode(path))
        assert good, image.message
        image.format = FORMAT_RGB
        self.width, self.height = image.width, image.height
        buffer = ctypes.create_string_buffer(3 * self.width * self.height)
        good = LIBPNG.png_image_finish_read(ctypes.byref(image), None, buffer, 0, None)
        assert good, image.message
        self.data = buffer.raw

    def part(self, columns, lines):
        """The bytes of a part of it, row by row."""
        left, right, _ = columns.indices(self.width)
        top, bottom, _ = lines.indices(self.height)
        return b"".join(self.data[3 * (y * self.width + left):3 * (y * self.width + right)]
                        for y in range(top, bottom))


def count_near(picture, colour, columns, lines, reach=36):
    """How many pixels are like this colour, in each channel."""
    part = picture.part(columns, lines)
    alike = -1
    for channel in range(3):
        middle = colour >> (16 - 8 * channel) & 255
        near = bytes(abs(value - middle) < reach for value in range(256))
        alike &= int.from_bytes(part[channel::3].translate(near), "big")
    return alike.bit_count()


def colours(picture, columns, lines):
    """How many different colours there are."""
    part = picture.part(columns, lines)
    return len(set(zip(part[0::3], part[1::3], part[2::3])))


def run(*arguments, environment=None):
    return subprocess.run([OPTIONS.inspector, *map(str, arguments)], capture_output=True,
                          text=True, timeout=180, env=environment)


def check_screenshot(folder, scene, theme, size):
    name = f"{scene} {theme} {size}"
    file = folder / "window.png"
    done = run(OPTIONS.data / "scenes" / f"{scene}.json", "--screenshot", file, "--theme", theme,
               "--size", size)
    check(name, done.returncode == 0, done.stderr)
    picture = Picture(file)
    width, height = picture.width, picture.height
    check(name, f"{width}x{height}" == size, f"{width}x{height}")
    # The 3D view lies to the right of the middle third, above the outline.
    columns, lines = slice(width * 35 // 100, width), slice(height // 10, height * 60 // 100)
    for ray, colour in RAYS[theme].items():
        found = count_near(picture, colour, columns, lines)
        check(name, found > 120, f"{found} pixels in the colour of {ray}")
    tones = colours(picture, columns, lines)
    check(name, tones > 600, f"the 3D view has {tones} colours")
    tones = colours(picture, slice(40, width // 4), slice(height // 8, height * 40 // 100))
    check(name, tones > 1000, f"the picture has {tones} colours")


def check_answers(folder):
    done = run("--version")
    check("version", done.returncode == 0 and re.fullmatch(r"raytree \d+\.\d+\.\d+\n", done.stdout),
          done.stdout)
    done = run("--help")
    check("help", done.returncode == 0 and done.stdout.startswith("Examples:"), done.stdout)
    scene = OPTIONS.data / "scenes" / "glass-ball.json"
    without = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    done = run(scene, environment=without)
    check("no display", done.returncode == 3 and done.stderr.count("\n") == 1
          and "display" in done.stderr, (done.returncode, done.stderr))
    broken = folder / "broken.json"
    broken.write_text('{"format": "raytree-scene/1.0", "camera"')
    target = folder / "never.png"
    for name, arguments, word in [
            ("missing file", ["no-such.json"], "no-such.json"),
            ("broken file", [broken], "broken.json"),
            ("folder", [folder], "is a folder"),
            ("pixel outside", [scene, "--pixel", "640,0"], "640,0"),
            ("pixel misspelt", [scene, "--pixel", "12"], "I,J"),
            ("unknown option", [scene, "--pixle", "1,2"], "--pixle"),
            ("bad size", [scene, "--size", "1x1"], "--size"),
            ("bad theme", [scene, "--theme", "pink"], "--theme"),
            ("unknown command", [scene, "--script", script(folder, "no.such")], "no.such"),
            ("unwritable", [scene, "--screenshot", folder / "none" / "x.png"], "x.png"),
            ("two files", [scene, scene], "one file")]:
        if name != "unwritable":
            arguments = [*arguments, "--screenshot", target]
        done = run(*arguments)
        check(name, done.returncode == 2 and word in done.stderr, (done.returncode, done.stderr))
        check(name, not target.exists(), "it has written a file")


def script(folder, *lines):
    file = folder / "script.txt"
    file.write_text("\n".join(lines))
    return file


def check_scripts_that_stop(folder):
    """Each says the line, what was found, and what would do; what a hand would be asked for, too."""
    scene = OPTIONS.data / "scenes" / "glass-ball.json"
    for line, word in [("pixel.pick 640,0", "639,479"),
                       ("ray.select 99999", "99999"),
                       ("step.to 99999", "step's number from 1 to"),
                       ("step.to 0", "from 1"),
                       ("overlay.rays 3", "found '3'"),
                       ("change.set /settings/max_depth 0", "from 1 to 64"),
                       ("file.open", "file"),
                       ("export.tree_json", "file")]:
        target = folder / "never.png"
        done = run(scene, "--script", script(folder, "", line), "--screenshot", target)
        check(line, done.returncode == 2 and "script.txt: line 2" in done.stderr
              and word in done.stderr, (done.returncode, done.stderr))
        check(line, not target.exists(), "it has written a file")


def check_commands_left_out(folder):
    """What cannot be done just then is said, and the script goes on."""
    scene = OPTIONS.data / "scenes" / "glass-ball.json"
    for line in ["compare.next", "change.undo", "step.back"]:
        target = folder / "after.txt"
        done = run(scene, "--script", script(folder, line, f"export.tree_text {target}"),
                   "--screenshot", folder / "after.png")
        check(line, done.returncode == 0 and f"script.txt: line 1: {line} cannot be done"
              in done.stderr, (done.returncode, done.stderr))
        check(line, target.exists(), "the script did not go on")
        target.unlink(missing_ok=True)


def check_script(folder):
    """What commands do is to be seen."""
    scene = OPTIONS.data / "scenes" / "glass-ball.json"
    counts = []
    for lines in [["ray.primary"], ["show.shadow"]]:
        file = folder / "scripted.png"
        done = run(scene, "--script", script(folder, *lines), "--screenshot", file)
        check("script", done.returncode == 0, done.stderr)
        picture = Picture(file)
        counts.append(count_near(picture, RAYS["light"]["lit"],
                                 slice(picture.width * 35 // 100, None),
                                 slice(picture.height // 10, picture.height * 55 // 100)))
    check("script hides shadow rays", counts[1] < counts[0] / 4, counts)


def shown(folder, scene, theme, *lines, size="1280x800"):
    """What the window shows after a script."""
    file = folder / "shown.png"
    done = run(OPTIONS.data / "scenes" / f"{scene}.json", "--theme", theme, "--size", size,
               "--script", script(folder, *lines), "--screenshot", file)
    check(f"{scene} {theme} {lines}", done.returncode == 0, done.stderr)
    return Picture(file)


def check_pictures_by_script(folder):
    """What a script writes of the window is as complete as a screenshot."""
    file = folder / "exported.png"
    last = shown(folder, "glass-ball", "light", "overlay.levels", f"export.window {file}")
    picture = Picture(file)
    part = slice(picture.width // 4), slice(picture.height // 10, picture.height * 40 // 100)
    check("export in a script", picture.part(*part) == last.part(*part), "is not complete")


def check_menu_by_script(folder):
    """A script goes on after a command that opens a menu."""
    shown(folder, "glass-ball", "light", "table.columns", "ray.child", size="900x640")


def check_diagram(folder):
    """With more room, the whole of a full tree is to be seen: boxes in the colours of their rays, the
    deepest level as well."""
    for theme, inks in RAYS.items():
        picture = shown(folder, "full-tree", theme, "pixel.pick 320,200", "tab.tall",
                        "tab.diagram")
        width, height = picture.width, picture.height
        right = slice(width * 33 // 100, width)
        top, low = height * 40 // 100, height * 97 // 100
        for kind in ["reflected", "refracted"]:
            found = count_near(picture, inks[kind], right, slice(top, low))
            check(f"diagram {theme}", found > 600, f"{found} pixels in the colour of {kind}")
        # Below the deepest level there is a margin.
        last = slice(height * 955 // 1000, low)
        ink = sum(count_near(picture, inks[kind], right, last)
                  for kind in ["reflected", "refracted"])
        check(f"diagram {theme}", ink == 0, f"{ink} pixels of boxes at the lower edge")


VIEWS = [  # commands, and what is to be seen then and what is not
    (["view.side"], ["primary", "reflected", "refracted", "lit", "selection"], []),
    (["view.camera"], ["reflected", "refracted", "lit"], []),
    (["view.fit_tree", "shapes.solid"], ["primary", "reflected", "refracted", "lit"], []),
    (["view.hit", "shapes.wire"], ["primary", "reflected", "refracted"], []),
    (["ray.child", "view.side"], ["primary", "lit", "selection"], []),
    (["ray.primary", "shapes.see_through", "show.reflected"],
     ["primary", "refracted", "lit", "selection"], ["reflected"]),
    (["show.reflected", "show.refracted"], ["primary", "reflected", "lit"], ["refracted"]),
    (["show.refracted", "show.shadow"], ["primary", "reflected", "refracted"], ["lit"]),
]


def check_views(folder):
    """Each view and each way to draw shapes shows the rays in their colours, in both themes; of rays
    that are hidden little is left: lights and surfaces of like colours."""
    width, height = 900, 560
    above_legend = slice(0, height - 90)
    for theme, inks in RAYS.items():
        lines = ["show.names"]  # words would cover rays
        for k, (commands, _, _) in enumerate(VIEWS):
            lines += [*commands, f"export.view {folder}/view{k}.png {width}x{height}"]
        done = run(OPTIONS.data / "scenes" / "glass-ball.json", "--theme", theme, "--pixel",
                   "210,286", "--script", script(folder, *lines, "file.quit"))
        check(f"views {theme}", done.returncode == 0, done.stderr)
        first = {}
        for k, (commands, seen, hidden) in enumerate(VIEWS):
            picture = Picture(folder / f"view{k}.png")
            count = {ray: count_near(picture, inks[ray], slice(0, width), above_legend)
                     for ray in seen + hidden}
            first = first or count
            name = f"views {theme} {' '.join(commands)}"
            check(name, all(count[ray] > 60 for ray in seen), count)
            check(name, all(count[ray] < first[ray] / 4 for ray in hidden), (first, count))


def check_selection_after_tab(folder):
    """The 3D view shows the selected ray whatever tab the tree is in."""
    scene = OPTIONS.data / "scenes" / "glass-ball.json"
    views = []
    for lines in [["ray.select 5"], ["tab.diagram", "ray.select 5"], ["tab.diagram"]]:
        file = folder / "selected.png"
        done = run(scene, "--pixel", "210,286", "--script", script(folder, *lines),
                   "--screenshot", file, "--size", "1280x800")
        check("selection after tab", done.returncode == 0, done.stderr)
        picture = Picture(file)
        views.append(picture.part(slice(picture.width * 35 // 100, None),
                                  slice(picture.height // 10, picture.height * 55 // 100)))
    other = sum(a != b for a, b in zip(views[0], views[1]))
    unselected = sum(a != b for a, b in zip(views[0], views[2]))
    check("selection after tab", other < unselected / 4, (other, unselected))


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        check_answers(folder)
        check_screenshot(folder, "glass-ball", "light", "1280x800")
        check_screenshot(folder, "glass-ball", "dark", "1920x1080")
        check_scripts_that_stop(folder)
        check_commands_left_out(folder)
        check_script(folder)
        check_selection_after_tab(folder)
        check_pictures_by_script(folder)
        check_menu_by_script(folder)
        check_diagram(folder)
        check_views(folder)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inspector", required=True)
    parser.add_argument("--data", required=True, type=Path)
    OPTIONS = parser.parse_args()
    sys.exit(main())
