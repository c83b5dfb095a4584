"""The programs in the package's README and in that of rsh."""

import re
from pathlib import Path

import pytest

READMES = [Path(__file__).parents[up] / "README.md" for up in (1, 3)]
PROGRAMS = [re.findall(r"```python\n(.*?)```", readme.read_text(), re.DOTALL) for readme in READMES]


def test_both_have_programs():
    assert all(PROGRAMS)


@pytest.mark.parametrize("program", sum(PROGRAMS, []))
def test_program_prints_something(program, capsys):
    exec(compile(program, "README.md", "exec"), {})
    assert capsys.readouterr().out
