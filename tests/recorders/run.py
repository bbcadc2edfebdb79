#!/usr/bin/env python3
"""Runs the sample tracer of one of lib/recorders, and holds what it records against the truth."""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
PIXELS = ["0,0", "16,12", "20,9", "22,7", "13,16", "18,10"]
LONGEST = 150  # lines of a recorder

RECORDERS = {"cpp": "raytree_recorder.h", "python": "raytree_recorder.py",
             "javascript": "raytree-recorder.mjs", "java": "RaytreeRecorder.java"}


def prepared(arguments, source, folder):
    """The command that runs the sample, compiled where it must be; None without the language."""
    if arguments.language == "cpp":
        compile_it = [arguments.cxx, "-std=c++17", "-Wall", "-Wextra", "-Wconversion", "-pedantic",
                      "-Werror", source / "sample.cpp", "-o", folder / "sample"]
        subprocess.run(compile_it, check=True)
        return [folder / "sample"]
    if arguments.language == "python":
        return [sys.executable, "-B", source / "sample.py"]
    if arguments.language == "javascript":
        node = shutil.which("node")
        return node and [node, source / "sample.mjs"]
    compiler, java = shutil.which("javac"), shutil.which("java")
    if not compiler or not java:
        return None
    subprocess.run([compiler, "-d", folder, *source.glob("*.java")], check=True)
    return [java, "-Xshare:auto", "-cp", folder, "Sample"]


def broken(tree):
    """The same with one number that is none, as the recorders write it."""
    document = json.loads(tree)
    document["rays"][-1]["intensity"] = ["NaN", 0, 0]
    return json.dumps(document)


def check(arguments, folder, text, *options):
    file = folder / "tree.json"
    file.write_text(text)
    scene = arguments.recorders / "sample-scene.json"
    return subprocess.run([arguments.raytree, "check", file, "--scene", scene, *options],
                          capture_output=True, text=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--raytree", required=True, type=Path, help="the program")
    parser.add_argument("--recorders", required=True, type=Path, help="lib/recorders")
    parser.add_argument("--cxx", default="g++", help="the C++ compiler")
    parser.add_argument("language", choices=RECORDERS)
    arguments = parser.parse_args()
    source = arguments.recorders / arguments.language
    lines = len((source / RECORDERS[arguments.language]).read_text().splitlines())
    failures = 0 if lines < LONGEST else print(f"the recorder has {lines} lines") or 1
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        command = prepared(arguments, source, folder)
        if not command:
            print(f"skipped: {arguments.language} is not on this machine")
            return SKIPPED
        for pixel in PIXELS:
            done = subprocess.run([*command, *pixel.split(",")], capture_output=True, text=True)
            answer = check(arguments, folder, done.stdout, "--profile", "lecture", "--require",
                           "origin,direction,hit,object,t,normal,intensity,blocked_by")
            if done.returncode or done.stderr or answer.returncode or ": pass" not in answer.stdout:
                print(f"{pixel}: {done.stderr}{answer.stdout}{answer.stderr}")
                failures += 1
        answer = check(arguments, folder, broken(done.stdout))
        if answer.returncode != 1 or "NaN" not in answer.stdout:
            print(f"a number that is none: {answer.stdout}{answer.stderr}")
            failures += 1
    print(f"{arguments.language}: {len(PIXELS)} trees, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
