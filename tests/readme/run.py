"""Runs what the README tells its readers to run, and compares what it shows with what comes out.

    run.py README RAYTREE DATA_FOLDER

Every indented line that begins with build/bin/raytree is run. The outline that is quoted must be
a piece of what the command before it prints, line by line.
"""

import pathlib
import subprocess
import sys
import tempfile


def indented(lines):
    return [line[4:] for line in lines if line.startswith("    ")]


def quoted_outline(lines):
    block = []
    for line in lines:
        if line.startswith("    #0 ") or (block and line.startswith("    ")):
            block.append(line[4:].rstrip())
        elif block:
            break
    return block


def main():
    readme, raytree, data = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    lines = readme.read_text().splitlines()
    commands = [line for line in indented(lines) if line.startswith("build/bin/raytree ")]
    outline = "\n".join(quoted_outline(lines))
    shown = False
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        (here / "build").mkdir()
        (here / "build" / "bin").symlink_to(raytree.parent)
        (here / "data").symlink_to(data)
        for command in commands:
            done = subprocess.run(command.split(), cwd=here, capture_output=True, text=True)
            printed = "\n".join(line.rstrip() for line in done.stdout.splitlines())
            shown = shown or (outline and outline in printed)
            if done.returncode != 0:
                failed += 1
                print(f"{command}: exit code {done.returncode}: {done.stderr}")
    if not shown:
        failed += 1
        print("the outline in the README is not what the command prints")
    print(f"{len(commands)} commands of the README run, {failed} failed")
    return 1 if failed or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
