"""Holds the ray trees that raytree exports against the schema.

    exported.py RAYTREE SCHEMA_FOLDER SCENE...

Of every scene nine pixels are traced: in double with the scene inside, in reference without it, and
with the bounds of their errors.
"""

import json
import pathlib
import subprocess
import sys

import validate


def pixels(scene):
    width, height = scene["camera"]["width"], scene["camera"]["height"]
    return [f"{width * i // 10},{height * j // 10}" for i in (2, 5, 8) for j in (3, 5, 8)]


def main():
    raytree, schemas, *scenes = sys.argv[1:]
    validators = validate.load_validators(pathlib.Path(schemas))
    checked = bad = 0
    for path in map(pathlib.Path, scenes):
        for pixel in pixels(json.loads(path.read_text())):
            for options in (["--embed-scene"], ["--precision", "reference"], ["--error-bounds"]):
                command = [raytree, "trace", path, "--pixel", pixel, *options]
                tree = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
                checked += 1
                for error in validators[tree["format"]].iter_errors(tree):
                    print(f"{path.name} {pixel}: {validate.pointer(error)}: {error.message[:200]}")
                    bad += 1
    print(f"{checked} exported trees, {bad} mistakes")
    return 1 if bad or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
