#!/usr/bin/env python3
"""Runs raytree from outside and holds what it answers, writes and refuses against the tables in
cases.py and inputs.py, and its pictures against what is known of them (pictures.py)."""

import argparse
import os
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import checking
import homework
import inputs
import lessons
import pictures
import terminal
from cases import COMMANDS

SKIPPED = 77


class Bench:
    """A folder with the inputs in it, where raytree is run; it collects what is wrong."""

    def __init__(self, arguments, folder):
        self.raytree = arguments.raytree
        self.data = arguments.data
        self.shared = arguments.shared
        self.slow = arguments.slow
        self.folder = folder
        self.failures = 0
        self.tests = 0
        (folder / "folder.json").mkdir()
        (folder / "folder.png").mkdir()
        for name, text in inputs.FILES.items():
            self.write(name, text)

    def write(self, name, text):
        data = text if isinstance(text, bytes) else text.encode()
        (self.folder / name).write_bytes(data)

    def run(self, command, seconds=10):
        """The finished process; commands are words in one string, or a list."""
        words = command if isinstance(command, list) else shlex.split(command)
        return subprocess.run([self.raytree, *words], cwd=self.folder, capture_output=True,
                              timeout=seconds * (10 if self.slow else 1))

    def measured(self, command):
        """(finished process, seconds, largest memory in MB) of a command."""
        words = command if isinstance(command, list) else shlex.split(command)
        started = time.monotonic()
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            process = subprocess.Popen([self.raytree, *words], cwd=self.folder, stdout=out,
                                       stderr=err)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            texts = []
            for stream in (out, err):
                stream.seek(0)
                texts.append(stream.read())
        done = subprocess.CompletedProcess(words, process.returncode, *texts)
        # On a busy machine what the program itself has taken tells more than the clock.
        seconds = min(time.monotonic() - started, used.ru_utime + used.ru_stime)
        return done, seconds, used.ru_maxrss / 1024

    def files(self):
        return {p.relative_to(self.folder).as_posix(): (p.stat().st_mtime_ns, p.stat().st_size)
                for p in self.folder.rglob("*") if p.is_file()}

    def check(self, name, good, text=""):
        self.tests += 1
        if not good:
            self.failures += 1
            print(f"FAILED  {name}: {text}", flush=True)
        return good

    def expect(self, name, command, code, out, err, written="", seconds=10):
        """Runs a command and checks all that is to be seen of it."""
        before = self.files()
        try:
            done = self.run(command, seconds)
        except subprocess.TimeoutExpired:
            return self.check(name, False, f"took too long: raytree {command}")
        after = self.files()
        touched = {f for f in after if after[f] != before.get(f)}
        for file in touched - before.keys():
            (self.folder / file).unlink()
        wrong = []
        if done.returncode != code:
            wrong.append(f"exit code {done.returncode}, not {code}")
        for stream, text, pattern in (("output", done.stdout, out), ("error", done.stderr, err)):
            text = text.decode("latin-1" if text.startswith(b"\x89PNG") else "utf-8", "replace")
            if not (re.search(pattern, text) if pattern else text == ""):
                wrong.append(f"standard {stream} is not {pattern!r} but {text[:600]!r}")
        if touched != set(written.split()) or not before.keys() <= after.keys():
            wrong.append(f"wrote {sorted(touched)}")
        return self.check(name, not wrong, "\n        ".join([f"raytree {command}", *wrong]))


def commands(bench):
    for name, command, code, out, err, *written in COMMANDS:
        bench.expect(name, command, code, out, err, *written)
    # Beside each other: on a machine that is busy, both take longer.
    starts = [(timed([bench.raytree, "--version"]), timed([sys.executable, "-S", "-c", "pass"]))
              for _ in range(20)]
    ours, python = (min(times) for times in zip(*starts))
    bench.check("--version takes less processor time than Python takes to start",
                bench.slow or ours < python, f"{1000 * ours:.1f} ms, {1000 * python:.1f} ms")
    with open("/dev/full", "wb") as full:
        done = subprocess.run([bench.raytree, "info", "scene.json"], cwd=bench.folder, stdout=full,
                              stderr=subprocess.PIPE)
    bench.check("standard output is full",
                done.returncode == 2 and b"standard output" in done.stderr, str(done))


def timed(command):
    """Seconds of processor time."""
    begin = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, capture_output=True, check=True)
    end = resource.getrusage(resource.RUSAGE_CHILDREN)
    return end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime


def bad_input(bench):
    for name, text, message in inputs.BAD_SCENES:
        bench.write("bad.json", text)
        for command in ("info bad.json", "trace bad.json --pixel 0,0", "render bad.json -o bad.png",
                        "convert bad.json bad.nff"):
            bench.expect(f"{name}: {command}", command, 2, "",
                         rf"(?s)^raytree: bad\.json: .*?(?:{message})")
    for name, text, message in inputs.BAD_FOREIGN:
        bench.write(name, text)
        bench.expect(name, f"info {name}", 2, "", message)
        bench.expect(name, f"render {name} -o bad.png", 2, "", message)


GROUPS = {"commands": commands, "bad_input": bad_input, "check": checking.checking,
          "homework": homework.homework,
          "limits": pictures.limits, "pictures": pictures.pictures,
          "shared_data": pictures.shared_data, "terminal": terminal.terminal,
          "lesson": lessons.lessons}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--raytree", required=True, type=Path, help="the program")
    parser.add_argument("--data", required=True, type=Path, help="the project's data folder")
    parser.add_argument("--shared", type=Path, help="scenes and expected pictures by others")
    parser.add_argument("--slow", action="store_true", help="instrumented: allow ten times as long")
    parser.add_argument("group", choices=GROUPS)
    arguments = parser.parse_args()
    for name in ("raytree", "data", "shared"):
        path = getattr(arguments, name)
        setattr(arguments, name, path and path.resolve())
    if arguments.group == "shared_data" and not (arguments.shared and arguments.shared.is_dir()):
        print("skipped: there is no folder of shared data")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, Path(folder))
        GROUPS[arguments.group](bench)
    print(f"{arguments.group}: {bench.tests} checks, {bench.failures} failed")
    return 1 if bench.failures else 0


if __name__ == "__main__":
    sys.exit(main())
