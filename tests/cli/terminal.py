"""What is different where standard output or standard error is a terminal."""

import os
import pty
import re
import subprocess


def at_terminal(bench, command, stream, **environment):
    """What a terminal shows of one stream of the command, as text."""
    ours, theirs = pty.openpty()
    streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, stream: theirs}
    process = subprocess.Popen([bench.raytree, *command.split()], cwd=bench.folder, **streams,
                               env={"PATH": "/usr/bin", "TERM": "xterm"} | environment)
    os.close(theirs)
    shown = b""
    try:
        while piece := os.read(ours, 1 << 16):
            shown += piece
    except OSError:  # Linux says so when the other end is closed
        pass
    os.close(ours)
    bench.check(f"exit code of {command}", process.wait() == 0)
    return shown.decode()


def terminal(bench):
    trace = "trace scene.json --pixel 16,12 --as text"
    plain = bench.run(trace).stdout.decode()
    coloured = at_terminal(bench, trace, "stdout")
    bench.check("an outline is coloured at a terminal", "\x1b[" in coloured)
    bare = re.sub(r"\x1b\[[0-9;]*m", "", coloured)
    bench.check("nothing is told by colour alone",
                [line.rstrip() for line in bare.splitlines()] == plain.splitlines())
    shown = at_terminal(bench, trace, "stdout", NO_COLOR="1").replace("\r\n", "\n")
    bench.check("NO_COLOR is respected", shown == plain)
    shown = at_terminal(bench, "trace scene.json --pixel 1,1", "stdout")
    bench.check("data are never coloured", "\x1b" not in shown)

    shown = at_terminal(bench, "render scene.json -o p.png", "stderr")
    bench.check("no bar for quick work", shown == "", repr(shown))
    shown = at_terminal(bench, "render hall.json -o p.png --size 3x3 --threads 1", "stderr")
    bench.check("a bar for slow work, wiped away",
                re.fullmatch(r"(\rrendering \[#*\.*\] +\d+ %)+\r\x1b\[K", shown), repr(shown[:300]))
