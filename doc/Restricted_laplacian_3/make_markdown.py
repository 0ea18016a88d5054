#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders the pages of the manual as Markdown, to be read where the sources are: make_markdown.py
[--check]

Writes markdown/NAME.md for each NAME.txt that holds a page. With --check writes nothing, and fails if
a file there is not what the present page gives. Knows the commands that the pages use; another one is
an error.
"""

import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the test leaves nothing beside the sources
from check_links import heading_anchor  # noqa: E402

DOC = pathlib.Path(__file__).resolve().parent
ROOT = DOC.parents[1]
EXAMPLES = "../../../examples/"
INCLUDED = [ROOT / "examples", ROOT / "scripts", ROOT / "test/Restricted_laplacian_3/project",
            DOC / "outputs"]
TITLE = re.compile(r"^\\(page|mainpage|section|subsection)(?: (RL_\w+))? (.*)$")
COMMAND = re.compile(r"\\(anchor|authors|cgal(AutoToc|BibEntry|Example|Figure\w+)|code|dontinclude|f\["
                     r"|include|skip|until|verbinclude)")
LEVELS = {"page": 1, "mainpage": 1, "section": 2, "subsection": 3}


def plain(title):
    return title.replace("%", "").replace("\\cgal", "CGAL")


def included(name):
    for folder in INCLUDED:
        if (folder / name).is_file():
            return (folder / name).read_text(encoding="utf-8").rstrip("\n").split("\n")
    raise ValueError(f"there is no {name}")


class Manual:
    """The pages, and where the names lead that they refer to."""

    def __init__(self):
        self.pages = {}
        self.targets = {}  # from a name to a link and its text
        for path in sorted(DOC.glob("*.txt")):
            text = path.read_text(encoding="utf-8")
            found = re.search(r"/\*!\n(\\(?:main)?page .*?)\n\*/", text, re.S)
            if not found or path.name == "PackageDescription.txt":
                continue
            file = path.stem + ".md"
            self.pages[path.stem] = found.group(1).split("\n")
            number = 0
            for line in self.pages[path.stem]:
                title = TITLE.match(line)
                figure = re.match(r"\\cgalFigureBegin\{(\w+),", line)
                entry = re.match(r"\\cgalBibEntry\{(\w+)\}", line)
                if title and title.group(2):
                    link = file if "page" in title.group(1) else f"{file}#{heading_anchor(plain(title.group(3)))}"
                    self.targets[title.group(2)] = (link, plain(title.group(3)))
                elif figure:
                    number += 1
                    self.targets["fig__" + figure.group(1)] = (file, str(number))
                elif entry:
                    self.targets["RL_bib_" + entry.group(1)] = (file, f"[{entry.group(1)}]")

    def reference(self, match):
        name, text = match.group(1), match.group(2)
        if "/" in name:
            return f"[{text or name.split('/')[-1]}]({EXAMPLES}{name})"
        if name not in self.targets:  # of the Reference Manual
            return text or {"RL_named_parameters": "Named Parameters"}.get(name, f"`{name}`")
        link, title = self.targets[name]
        return f"[{text or title}]({link})"

    def inline(self, text):
        """a paragraph or a line; what stands in backquotes or in a formula remains as it is"""
        kept = []

        def keep(match):
            kept.append(f"$`{match.group(1)}`$" if match.group(1) is not None else match.group())
            return f"\0{len(kept) - 1}\0"

        text = re.sub(r"\\f\$(.*?)\\f\$|`[^`]*`", keep, text, flags=re.S)
        text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.S)
        text = re.sub(r"\\(?:ref|subpage) ([\w/.]*\w)(?: \"([^\"]*)\")?", self.reference, text)
        text = re.sub(r"\\cgalCite\{(\w+)\}",
                      lambda m: "[\\[{}\\]]({})".format(m.group(1),
                                                       self.targets["RL_bib_" + m.group(1)][0]),
                      text)
        text = re.sub(r"\\cgal\b", "CGAL", text)
        text = re.sub(r"<a href=[^>]*>(.*?)</a>", r"\1", text)
        text = re.sub(r"</?b>", "**", text)
        text = re.sub(r"</?em>", "*", text)
        text = re.sub(r"<tt>(.*?)</tt>", r"`\1`", text)
        text = re.sub(r"%(\w)", r"\1", text).replace("\\#", "#")
        unknown = re.search(r"\\[A-Za-z]\w*", text)
        if unknown:
            raise ValueError(f"unknown command {unknown.group()}")
        return re.sub("\0(\\d+)\0", lambda m: kept[int(m.group(1))], text)

    def render(self, name):
        result = [f"<!-- made from ../{name}.txt by make_markdown.py -->", ""]
        prose = []
        source = []  # of excerpts, what has not been passed

        def end_prose():
            if prose:
                result.extend(self.inline("\n".join(prose)).split("\n"))
                prose.clear()

        def fence(language, lines):
            if result[-1]:
                result.append("")
            result.extend([f"```{language}", *lines, "```"])

        lines = iter(self.pages[name])
        for line in lines:
            title = TITLE.match(line)
            command, _, argument = line.partition(" ")
            if not title and not COMMAND.match(line):
                prose.append(re.sub(r"^-# ", "1. ", line))
                continue
            end_prose()
            if title:
                result.append("#" * LEVELS[title.group(1)] + " " + self.inline(title.group(3)))
            elif line.startswith("\\code"):
                language = re.sub(r"\\code(\{\.(\w+)\})?", r"\2", line)
                block = []
                for code in lines:
                    if code == "\\endcode":
                        break
                    block.append(code)
                fence("" if language == "unparsed" else language, block)
            elif command in ("\\include", "\\verbinclude"):
                is_cmake = argument.endswith("CMakeLists.txt")
                fence("cmake" if is_cmake else "", included(argument))
            elif command == "\\dontinclude":
                source = included(argument)
                fence("cpp", [])
            elif command in ("\\skip", "\\until"):
                position = next(i for i, code in enumerate(source) if argument in code)
                if command == "\\until":
                    result[-1:] = [*source[:position + 1], "```"]
                    position += 1
                source = source[position:]
            elif line.startswith("\\cgalExample"):
                file = re.search(r"\{(.*)\}", line).group(1)
                result.append(f"File [{file.split('/')[-1]}]({EXAMPLES}{file})")
            elif command == "\\f[":
                formula = [line[3:].strip()]
                while not formula[-1].rstrip(" .").endswith("\\f]"):
                    formula.append(next(lines))
                fence("math", "\n".join(formula).replace("\\f]", "").strip().split("\n"))
            elif line.startswith("\\cgalFigureBegin"):
                name_of_figure, file = re.search(r"\{(\w+),([\w.]+)\}", line).groups()
                result.append(f"![](../fig/{file})")
            elif line.startswith("\\cgalFigureCaptionBegin"):
                name_of_figure = re.search(r"\{(\w+)\}", line).group(1)
                result.append("")
                prose.append(f"<b>Figure {self.targets['fig__' + name_of_figure][1]}.</b>")
            elif line.startswith("\\cgalBibEntry"):
                result.append("**[{}]**".format(re.search(r"\{(\w+)\}", line).group(1)))
        end_prose()
        text = "\n".join(result)
        text = re.sub(r"(\n\|[^\n]*)\n(?=[^|\n])", r"\1\n\n", text)  # else a row of the table
        return re.sub(r"\n{3,}", "\n\n", text).strip("\n") + "\n"


def main():
    is_check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not is_check:
        sys.exit(__doc__)
    folder = DOC / "markdown"
    manual = Manual()
    texts = {}
    for name in manual.pages:
        try:
            texts[f"{name}.md"] = manual.render(name)
        except (ValueError, StopIteration) as error:
            sys.exit(f"{name}.txt: {error or 'an excerpt looks for what is not there'}")
    present = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.md")}
    if is_check:
        old = [name for name in {**texts, **present} if texts.get(name) != present.get(name)]
        if old or not texts:
            sys.exit(f"run make_markdown.py: {', '.join(sorted(old))}")
        print(f"{len(texts)} pages are up to date")
        return
    folder.mkdir(exist_ok=True)
    for name in present.keys() - texts.keys():
        (folder / name).unlink()
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


main()
