"""Checks the type hints: mypy of the package (strictly) and of the notebooks' code, and that the stub of the
module in C++ is true.

    types_test.py FOLDER    for what it writes meanwhile
"""

import ast
import json
import os
import pathlib
import re
import subprocess
import sys

from polhode import _core

PYTHON = pathlib.Path(__file__).resolve().parents[2] / "python"
STUB = PYTHON / "polhode" / "_core.pyi"
# mypy's stubtest does not know pybind11's metaclass, nor that a class cannot be made.
NOT_IN_STUB = r"""
polhode\._core\.(Motion|SchemeHandle|State|Torque|TorqueLaw)
polhode\._core\.(SchemeHandle|TorqueLaw)\.__init__
"""


def code_of(notebook):
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code") + "\n"


def mypy_checks(folder):
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", str(folder / "mypy_cache")]
    yield [*mypy, "--strict", str(PYTHON / "polhode")]
    notebooks = sorted((PYTHON / "notebooks").glob("*.ipynb"))
    assert notebooks
    for notebook in notebooks:
        code = folder / f"{notebook.stem}.py"
        code.write_text(code_of(notebook), encoding="utf-8")
        yield [*mypy, "--check-untyped-defs", "--ignore-missing-imports", str(code)]
    allowed = folder / "allowed.txt"
    allowed.write_text(NOT_IN_STUB, encoding="utf-8")
    yield [sys.executable, "-m", "mypy.stubtest", "--allowlist", str(allowed), "polhode._core"]


def parameters_in_stub():
    """Yields the dotted name of each function of the stub with the names of its parameters."""
    for node in ast.parse(STUB.read_text(encoding="utf-8")).body:
        functions = node.body if isinstance(node, ast.ClassDef) else [node]
        for function in functions:
            is_operator = isinstance(function, ast.FunctionDef) and function.name.endswith("add__")
            if isinstance(function, ast.FunctionDef) and not function.decorator_list and not is_operator:
                path = f"{node.name}.{function.name}" if node is not function else function.name
                arguments = function.args.args + function.args.kwonlyargs
                yield path, [argument.arg for argument in arguments if argument.arg != "self"]


def parameters_at_run_time(path):
    """Reads them from the signature in the documentation, which is all that pybind11 gives."""
    function = _core
    for name in path.split("."):
        function = getattr(function, name)
    signature = function.__doc__.splitlines()[0]
    return [name for name in re.findall(r"[(,] ?(\w+):", signature) if name != "self"]


def main():
    folder = pathlib.Path(sys.argv[1])
    failed = [
        check
        for check in mypy_checks(folder)
        if subprocess.run(check, cwd=folder, env=os.environ, check=False).returncode != 0
    ]
    for path, in_stub in parameters_in_stub():
        at_run_time = parameters_at_run_time(path)
        if at_run_time != in_stub:
            failed.append(f"{path}: {at_run_time} in the module, {in_stub} in the stub")
    sys.exit("\n".join(map(str, ["failed:", *failed])) if failed else 0)


if __name__ == "__main__":
    main()
