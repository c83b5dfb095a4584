"""The README's programs."""

import re
from pathlib import Path

import pytest

README = Path(__file__).parents[1] / "README.md"
PROGRAMS = re.findall(r"```python\n(.*?)```", README.read_text(), re.DOTALL)


@pytest.mark.parametrize("program", PROGRAMS)
def test_program_prints_something(program, capsys):
    exec(compile(program, str(README), "exec"), {})
    assert capsys.readouterr().out
