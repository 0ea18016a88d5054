#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the spelling of the manual, of the comments that Doxygen reads, and of the Markdown files:
check_spelling.py --root FOLDER --hunspell PROGRAM

The spelling is American, as that of names in the code. Code, formulas and what stands in quotation marks are left out,
and so is the bibliography, which quotes titles. Words that the dictionary does not know are in
spelling_words.txt beside this file, one on a line, sorted, in the singular, with a small first
letter unless it is a name; one that is used no more is an error.
"""

import argparse
import pathlib
import re
import subprocess
import sys

DICTIONARY = "en_US"

# What is no prose, in the order in which it is taken out. Line breaks stay, for the line numbers.
NO_PROSE = [
    r"<!--.*?-->",
    r"^```.*?^```",
    r"(?<=\n\n)(    [^\n]*\n)+",
    r"[\\@]code\b.*?[\\@]endcode",
    r"[\\@]verbatim\b.*?[\\@]endverbatim",
    r"[\\@]f\[.*?[\\@]f\]",
    r"[\\@]f\$.*?[\\@]f\$",
    r"[\\@]f\{.*?[\\@]f\}",
    r"<(pre|code)>.*?</\1>",
    r"`[^`]*`",
    r"\"[^\"\n]*\n?[^\"\n]*\"",
    r"</?\w+[^<>]*>",
    r"&\w+;",
    r"\]\([^)]*\)",
    r"\b(https?://|mailto:)[^\s)]*",
    # commands whose arguments are names up to the end of the line
    r"[\\@](cgalExample|cgalHasModel|cgalModels|cgalRefines|class|dontinclude|example|fn|headerfile"
    r"|include|line|namespace|skip|skipline|snippet|struct|typedef|until)\b[^\n]*",
    r"[\\@](image|cgalFigureBegin)\b[^\n]*",
    # commands whose first argument is a name
    r"[\\@](a|anchor|c|defgroup|ingroup|page|param(\[\w+\])?|ref|retval|section|subsection|throws"
    r"|tparam)\s+[\w:,./()-]+",
    r"[\\@](cgalBibEntry|cgalCite|cgalPkgBib|cgalParamNBegin|cgalPkgManuals)\{[^}]*\}",
    r"[\\@]\w+",
]


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def comments(text):
    """the comments that Doxygen reads, and nothing else"""
    kept = []
    inside = False
    for line in text.split("\n"):
        start = line.find("/*!")
        if start >= 0:
            inside = True
            line = " " * (start + 3) + line[start + 3:]
        if inside:
            end = line.find("*/")
            inside = end < 0
            kept.append(line if inside else line[:end])
        else:
            found = re.search(r"///<?(.*)", line)
            kept.append(found.group(1) if found else "")
    return "\n".join(kept)


def forms(word):
    """how a word of the list may be used"""
    return {start + ending for start in (word, word[0].upper() + word[1:]) for ending in ("", "s")}


def words_of(path):
    """pairs of a line number and a word"""
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".md":
        text = comments(text)
    for pattern in NO_PROSE:
        text = re.sub(pattern, blank, text, flags=re.M | re.S)
    for number, line in enumerate(text.split("\n"), 1):
        for chunk in re.split(r"[\s|{}\[\]()*,;!?\"–—…]+", line):
            chunk = chunk.strip(".:'’%#-/<>=+")
            # identifiers, file names, numbers with units
            if re.search(r"[\d_:=<>\\^~$&@]|\.\w|^\.|/\w*/", chunk):
                continue
            for word in re.split(r"[-/+%.]", chunk):
                word = re.sub(r"['’]s?$", "", word)
                if len(word) > 2:
                    yield number, word


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=pathlib.Path, required=True)
    parser.add_argument("--hunspell", required=True)
    arguments = parser.parse_args()

    doc = pathlib.Path(__file__).resolve().parent
    own = doc / "spelling_words.txt"
    include = arguments.root / "include/CGAL"
    files = [path for path in doc.glob("*.txt") if path not in (own, doc / "Bibliography.txt")]
    files += [*doc.glob("Concepts/*.h"), *doc.glob("*.doxy")]
    files += include.glob("*.h")
    files += (p for p in include.glob("Restricted_laplacian_3/**/*.h")
              if "internal" not in p.parts)
    files += arguments.root.glob("*.md")

    places = {}
    for path in sorted(files):
        for number, word in words_of(path):
            place = f"{path.relative_to(arguments.root)}:{number}"
            places.setdefault(word, []).append(place)

    command = [arguments.hunspell, "-i", "utf-8", "-d", DICTIONARY]
    try:
        # It ends with an error if there is no such dictionary.
        result = subprocess.run(command + ["-l"], input="\n".join(places), capture_output=True,
                                text=True, encoding="utf-8", check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"SKIPPED: hunspell with the dictionary {DICTIONARY} is needed: {error}")
        return 0
    unknown = set(result.stdout.split())

    listed = [line for line in own.read_text(encoding="utf-8").split("\n")
              if line and not line.startswith("#")]
    known = {form for word in listed for form in forms(word)}
    errors = 0
    if listed != sorted(set(listed), key=lambda word: (word.lower(), word)):
        print(f"{own.name} is not sorted")
        errors += 1
    for word in listed:
        if not forms(word) & places.keys():
            print(f"{own.name}: {word} is not used")
            errors += 1
    for word in sorted(places, key=str.lower):
        if word in unknown and word not in known:
            print(f"{word}: {', '.join(places[word][:5])}")
            errors += 1
    print(f"{len(places)} words in {len(files)} files, {errors} errors")
    return 1 if errors or not places else 0


if __name__ == "__main__":
    sys.exit(main())
