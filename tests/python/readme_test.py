"""The code in python/README.md runs, and prints what stands there."""

import pathlib
import re

import pytest

README = pathlib.Path(__file__).resolve().parents[2] / "python" / "README.md"


def without_times(table):
    return [line.rsplit(maxsplit=1)[0] for line in table.splitlines() if line.strip()]


def test_the_code_runs_and_prints_what_stands_there(capsys, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "agg")
    text = README.read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(blocks) == 4
    names = {}
    exec(blocks[0], names)
    printed = re.search(r"\n\n```\n(.*?)```", text, re.DOTALL).group(1)
    assert without_times(capsys.readouterr().out) == without_times(printed)
    for block in blocks[1:]:
        exec(block, names)
