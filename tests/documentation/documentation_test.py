"""Checks the project's Markdown files: links, code blocks and commands.

  documentation_test.py --source FOLDER --build FOLDER --installed FOLDER [--compiler PROGRAM] [--generator CMAKE'S]
                        [--slow] [-- FLAG...]

A comment on the line before a block says what differs from the usual:

  <!-- not compiled: REASON -->   a C++ block for code of somebody else
  <!-- not run: REASON -->        a command that cannot run here
  <!-- slow -->                   commands that run only with --slow
  <!-- output -->                 a text block: what the commands of the block before print, but for the last column
"""

import argparse
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from markdown_file import MarkdownFile

LANGUAGES = {"cpp", "cmake", "sh", "text", "json", "python", "bibtex"}
HERE = pathlib.Path(__file__).parent
options = None


def markdown_files():
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=options.source, capture_output=True, text=True)
    names = listed.stdout.split() if listed.returncode == 0 else []
    paths = [options.source / name for name in names] or [
        path for path in options.source.rglob("*.md") if "build" not in path.relative_to(options.source).parts]
    return [MarkdownFile(path, options.source) for path in sorted(paths) if path.exists()]


def blocks(language):
    return [block for file in markdown_files() for block in file.blocks if block.language == language]


class Links(unittest.TestCase):
    def test_every_relative_link_resolves(self):
        anchors = {file.path.resolve(): file.anchors for file in markdown_files()}
        for file in markdown_files():
            for line, target in file.links:
                with self.subTest(f"{file.name}:{line}: {target}"):
                    if re.match(r"[a-z]+:", target):
                        continue
                    name, _, anchor = target.partition("#")
                    path = (file.path.parent / name).resolve() if name else file.path.resolve()
                    self.assertTrue(path.exists(), "there is no such file")
                    if anchor:
                        self.assertIn(anchor, anchors.get(path, set()), "there is no such heading")


class TestNames(unittest.TestCase):
    """Words like `Suite.Test`, `Suite.*` and `Suite*` name tests."""

    def test_every_named_test_exists(self):
        sources = [path for path in (options.source / "tests").rglob("*.cpp")]
        tests = set(re.findall(r"^(?:TYPED_)?TEST(?:_P|_F)?\(\s*(\w+),\s*(\w+)\)", "\n".join(
            path.read_text(encoding="utf-8") for path in sources), re.MULTILINE))
        suites = {suite for suite, _ in tests}
        for file in markdown_files():
            for line, word in file.code_words:
                match = re.fullmatch(r"(?:\w+/)?([A-Z]\w*[a-z]\w*)(?:\.(\w+|\*)|\*)", word)
                if not match or word.split(".")[-1] in {"md", "h", "cpp", "txt", "json", "cmake", "hh", "cc", "cff"}:
                    continue
                with self.subTest(f"{file.name}:{line}: {word}"):
                    suite, name = match.groups()
                    if name is None:
                        self.assertTrue(any(known.startswith(suite) for known in suites), "there is no such suite")
                    elif name == "*":
                        self.assertIn(suite, suites)
                    else:
                        self.assertIn((suite, name), tests)


class Blocks(unittest.TestCase):
    def test_every_block_names_its_language(self):
        for file in markdown_files():
            self.assertEqual(file.indented, [], f"{file.name}: indented code; use a fence with a language")
            for block in file.blocks:
                with self.subTest(block.place):
                    self.assertIn(block.language, LANGUAGES)

    def test_json_parses(self):
        for block in blocks("json"):
            with self.subTest(block.place):
                json.loads(block.text)


class Code(unittest.TestCase):
    """C++ blocks become functions of one source file, or, with a class or a macro in them, namespaces."""

    def test_every_cpp_block_compiles(self):
        includes, bodies = [], []
        for number, block in enumerate(b for b in blocks("cpp") if not b.has_note("not compiled")):
            lines = []
            for line in block.text.replace("{ ... }", "{}").splitlines():
                (includes if line.startswith("#include") else lines).append(line)
            marker = f'#line {block.line + 1} "{block.file}"\n'
            text = marker + "\n".join("" if line.strip() == "..." else line for line in lines)
            at_file_scope = re.search(r"^(class|struct|namespace) ", text, re.MULTILINE)
            if "POLHODE_SCHEME_LIBRARY(" in text:
                bodies.append(text)
            elif at_file_scope:
                bodies.append(text)
            else:
                bodies.append(f"void block_{number}(Given& given) {{\nGIVEN\n{{\n{text}\n}}\n}}\n")
        self.assertGreater(len(bodies), 10)
        source = "\n".join(dict.fromkeys(includes)) + '\n#include "given.h"\n' + "\n".join(bodies)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "blocks.cpp"
            file.write_text(source)
            flags = subprocess.run(["pkg-config", "--cflags", "bullet", "eigen3"], check=True, capture_output=True,
                                   text=True).stdout.replace("-I", "-isystem ").split()
            compiled = subprocess.run(
                [options.compiler, *options.flags, "-std=c++17", "-fsyntax-only", "-DPOLHODE_BULLET_SCALAR_BITS=32",
                 "-I", options.source / "plugin/include", "-I", HERE, *flags, file],
                capture_output=True, text=True)
        self.assertEqual(compiled.returncode, 0, compiled.stderr)

    def test_every_cmake_block_configures(self):
        for block in blocks("cmake"):
            with self.subTest(block.place), tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                (folder / "main.cpp").write_text("int main() {}\n")
                (folder / "CMakeLists.txt").write_text(
                    "cmake_minimum_required(VERSION 3.18)\nproject(app CXX)\nadd_executable(app main.cpp)\n"
                    "find_package(PkgConfig REQUIRED)\npkg_check_modules(bullet REQUIRED IMPORTED_TARGET GLOBAL bullet)\n"
                    "add_library(my_bullet INTERFACE)\ntarget_link_libraries(my_bullet INTERFACE PkgConfig::bullet)\n"
                    + block.text)
                configured = subprocess.run(
                    ["cmake", "-G", options.generator, "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={options.installed}",
                     f"-DCMAKE_CXX_COMPILER={options.compiler}",
                     f"-DFETCHCONTENT_SOURCE_DIR_POLHODE={options.source}"],
                    capture_output=True, text=True)
                self.assertEqual(configured.returncode, 0, configured.stderr)


@unittest.skipUnless(importlib.util.find_spec("polhode"), "the Python package is not on the path")
class PythonCode(unittest.TestCase):
    def test_the_blocks_of_a_file_run_one_after_the_other(self):
        for file in markdown_files():
            text, output = "import matplotlib\nmatplotlib.use('agg')\n", ""
            for block in file.blocks:
                if block.language == "python":
                    text += block.text + "print('<end of block>')\n"
            if "<end of block>" not in text:
                continue
            with self.subTest(file.name), tempfile.TemporaryDirectory() as folder:
                run = subprocess.run([sys.executable, "-c", text], cwd=folder, capture_output=True, text=True)
                self.assertEqual(run.returncode, 0, run.stderr)
                outputs = iter(run.stdout.split("<end of block>\n"))
            for block in file.blocks:
                if block.language == "python":
                    output = next(outputs)
                elif block.language == "sh":
                    output = None
                elif block.has_note("output") and output is not None:
                    with self.subTest(block.place):
                        self.assertEqual(without_last_column(output), without_last_column(block.text))


class Commands(unittest.TestCase):
    """Runs the commands of sh blocks one by one in a folder of their own, where the demos are on the PATH."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ("hello_scheme.cpp", "hello_polhode.cpp", "scenarios/tumble.json"):
            shutil.copy(options.source / "demos" / name, self.folder)
        (self.folder / "tumble.json").rename(self.folder / "mine.json")
        folders = [options.build / "demos", options.build / "tools/run", *os.environ["PATH"].split(":")]
        pkg_config = [str(path.parent) for path in options.installed.rglob("polhode.pc")]
        self.environment = dict(os.environ, PATH=":".join(map(str, folders)), PKG_CONFIG_PATH=":".join(pkg_config),
                                EGL_PLATFORM="surfaceless", LIBGL_ALWAYS_SOFTWARE="1")

    def test_every_command_runs(self):
        count = 0
        for file in markdown_files():
            output = None
            for block in file.blocks:
                if block.language == "python":
                    output = None
                elif block.language == "sh" and not block.has_note("not run") and (
                        options.slow or not block.has_note("slow")):
                    outputs = [self.run_command(block, command) for command in block.commands()]
                    output = "".join(outputs)
                    count += len(outputs)
                elif block.has_note("output") and output is not None:
                    with self.subTest(block.place):
                        self.assertEqual(without_last_column(output), without_last_column(block.text))
        self.assertGreater(count, 20)

    def run_command(self, block, command):
        with self.subTest(f"{block.place}: {command}"):
            program = command.split()[0]
            if program.startswith("scripts/"):  # CI, or scripts/nightly, runs them
                self.assertTrue(os.access(options.source / program, os.X_OK), "there is no such script")
                return ""
            if program == "cmake":
                presets = json.loads((options.source / "CMakePresets.json").read_text())["configurePresets"]
                for preset in re.findall(r"--preset (\S+)", command):
                    self.assertIn(preset, [known["name"] for known in presets])
                return ""
            if program == "polhode_viewer" and "--screenshot" not in command:
                command += " --screenshot window.png"
            run = subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, capture_output=True,
                                 text=True, timeout=800)
            self.assertEqual(run.returncode, 0, run.stderr)
            return run.stdout
        return ""


def without_last_column(text):
    """The lines without what stands in their last column if that is a time."""
    return [re.sub(r"\s+\d+$", "", line.rstrip()) for line in text.strip().splitlines()]


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for name in ("source", "build", "installed"):
        parser.add_argument("--" + name, type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--generator", default="Ninja")
    parser.add_argument("--slow", action="store_true")
    parser.add_argument("flags", nargs="*")
    options = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
