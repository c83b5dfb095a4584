"""Bars are drawn where tqdm is and a terminal is looked at, and nowhere else."""

import fcntl
import os
import pty
import struct
import subprocess
import sys
import termios

import numpy as np
import pytest

import rsh
from rsh.progress import Bar, watched
from rsh.structs import Material, ReduceDesc

PROGRAM = """
import rsh
from rsh.progress import Bar, watched
with rsh.Context(cache_dir="") as context, Bar("programs") as bar:
    rsh.prepare(context, reduce=rsh.structs.ReduceDesc(count=1000, element_bytes=4), progress=bar)
assert list(watched(range(3), "frames")) == [0, 1, 2]
"""


def shown_on_a_terminal(program):
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    child = subprocess.Popen([sys.executable, "-c", program], stderr=slave)
    os.close(slave)
    shown = b""
    try:
        while piece := os.read(master, 4096):
            shown += piece
    except OSError:  # Linux's end of a terminal
        pass
    os.close(master)
    assert child.wait() == 0, shown
    return shown.decode()


def test_a_terminal_has_bars():
    shown = shown_on_a_terminal(PROGRAM)
    assert "programs:   0%" in shown
    assert "programs: 100%" in shown
    assert "frames:   0%" in shown


def test_elsewhere_there_are_none(capfd):
    with Bar("programs") as bar:
        bar(0, 2)
        bar(2, 2)
    assert list(watched(range(3), "frames")) == [0, 1, 2]
    assert capfd.readouterr().err == ""


def test_tqdm_need_not_be_there(monkeypatch, context):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    with Bar("programs") as bar:
        rsh.prepare(context, reduce=ReduceDesc(count=1000, element_bytes=4), progress=bar)
    assert list(watched(range(3), "frames")) == [0, 1, 2]


def test_the_waves_of_a_picture_are_told():
    scene = rsh.Scene([[-1, 0, -1], [1, 0, -1], [0, 0, 3]])
    camera = rsh.look_at([0, -4, 1], [0, 0, 1])
    mirror = np.zeros(1, np.dtype(Material))
    mirror["texture"], mirror["reflection"][:, :3] = rsh.NO_TEXTURE, 1
    waves = []
    rsh.render(scene, camera, 8, 8, materials=mirror, progress=lambda *wave: waves.append(wave))
    assert len(waves) > 0
    assert all(count == 0 for _, count in waves)
    with pytest.raises(ZeroDivisionError):
        rsh.render(scene, camera, 8, 8, materials=mirror, progress=lambda wave, _: 1 // 0)
