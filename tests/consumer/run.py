"""Uses raytree as somebody else's program would: installed, and as a folder of its source.

    run.py CMAKE RAYTREE_SOURCE RAYTREE_BUILD SCENE

The consumer is configured, built and run against an installation, and configured alone with the
source as a folder (which would only build the same library again).
"""

import json
import pathlib
import subprocess
import sys
import tempfile


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    cmake, source, build, scene = sys.argv[1:]
    consumer = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run(cmake, "--install", build, "--prefix", folder / "installed")
        run(cmake, "-S", consumer, "-B", folder / "found", "-G", "Ninja",
            f"-DCMAKE_PREFIX_PATH={folder / 'installed'}", "-DCMAKE_BUILD_TYPE=Release")
        run(cmake, "--build", folder / "found")
        said = run(folder / "found" / "consumer", scene)
        raytree = folder / "installed" / "bin" / "raytree"
        tree = json.loads(run(raytree, "trace", scene, "--pixel", "320,250"))
        expected = f"{len(tree['rays'])} rays, the primary one hits something\n"
        if said != expected:
            sys.exit(f"the consumer says {said!r}, the installed raytree {expected!r}")
        run(cmake, "-S", consumer, "-B", folder / "nested", "-G", "Ninja",
            f"-DRAYTREE_SOURCE_DIR={source}")


main()
