"""Reads a Markdown file: headings, links, code blocks."""

import dataclasses
import re


@dataclasses.dataclass
class Block:
    file: object
    line: int  # of the fence
    language: str
    text: str
    note: str  # of the comment on the line before, or empty

    @property
    def place(self):
        return f"{self.file}:{self.line}"

    def has_note(self, word):
        return self.note.split(":")[0].strip() == word

    def commands(self):
        """Returns the commands, those that go on after a backslash joined, without comments."""
        joined = re.sub(r"\\\n\s*", "", self.text)
        lines = [re.sub(r"\s+#.*$", "", line).strip() for line in joined.splitlines()]
        return [line for line in lines if line and not line.startswith("#")]


def anchor_of(heading):
    """Returns the fragment by which GitHub links to a heading."""
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading.strip()).replace("`", "")
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


class MarkdownFile:
    def __init__(self, path, root):
        self.path = path
        self.name = str(path.relative_to(root))
        self.anchors, self.links, self.code_words, self.blocks, self.indented = set(), [], [], [], []
        self._read(path.read_text(encoding="utf-8").splitlines())

    def _read(self, lines):
        fence, before = None, ""
        for number, line in enumerate(lines, 1):
            if fence is not None:
                if line.startswith("```"):
                    self.blocks.append(fence)
                    fence = None
                else:
                    fence.text += line + "\n"
            elif line.startswith("```"):
                note = re.fullmatch(r"<!-- (.*) -->", before)
                fence = Block(self.name, number, line[3:].strip(), "", note.group(1) if note else "")
            else:
                self._read_text(number, line, before)
            before = line
        if fence is not None:
            raise ValueError(f"{self.name}:{fence.line}: the block has no end")

    def _read_text(self, number, line, before):
        heading = re.match(r"#+ (.*)", line)
        if heading:
            self.anchors.add(anchor_of(heading.group(1)))
        if line.startswith("    ") and not before.strip():
            self.indented.append(number)
        self.code_words += [(number, word) for word in re.findall(r"`([^`\s]+)`", line)]
        prose = re.sub(r"`[^`]*`", "", line)
        self.links += [(number, target) for target in re.findall(r"\]\(([^)\s]+)\)", prose)]
