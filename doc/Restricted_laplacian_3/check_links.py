#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks links: check_links.py FOLDER_OF_HTML_OR_MARKDOWN_FILE...

Each link of a folder must lead to a file in that folder, and to an anchor that exists; pages load
nothing from elsewhere. Links of a Markdown file must lead to a file, or to a heading of such a file,
and so must paths in backquotes that begin with a folder beside it. External links are printed, not
fetched.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

# Debian's linkchecker finds the same, but takes minutes, and works as `nobody` if root starts it.

EXTERNAL = ("http", "https", "mailto")
# not pages of ours
MATHJAX = "mathjax"
GALLERY = "gallery"  # pages that programs make: make_gallery.sh misses those that none makes


class Page(html.parser.HTMLParser):
    """Anchors and links of an HTML page; a link is a pair of its address and whether it is loaded
    with the page."""

    def __init__(self, path):
        super().__init__()
        self.anchors = set()
        self.links = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if value is None:
                continue
            if name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)
            elif name in ("href", "xlink:href"):
                self.links.append((value, tag == "link"))
            elif name in ("src", "data", "poster"):
                self.links.append((value, True))


class Report:
    """What is wrong, and what leads elsewhere."""

    def __init__(self):
        self.errors = []
        self.external = set()
        self.number = 0

    def complain(self, path, link, what):
        self.errors.append(f"{path}: {link}: {what}")


def check_folder(folder, report):
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))
             if not {MATHJAX, GALLERY} & set(path.relative_to(folder).parts)}
    if not pages:
        report.complain(folder, "*.html", "there is no page")
    links = {path: page.links for path, page in pages.items()}
    for path in folder.rglob("stylesheet.css"):  # ours; some of Doxygen's name files that are not there
        found = re.findall(r"url\(\s*['\"]?([^'\")]+)", path.read_text(encoding="utf-8"))
        links[path] = [(link, True) for link in found]
    # The scripts of Doxygen name the pages of the navigation tree and those that a search finds. Its
    # index of the tree is no link: it tells where pages are in the tree.
    for path in folder.rglob("*.js"):
        if MATHJAX not in path.relative_to(folder).parts and "navtreeindex" not in path.name:
            text = path.read_text(encoding="utf-8").split("var NAVTREEINDEX")[0]
            found = re.findall(r"['\"]([^'\"\s<>]+\.html(?:#[^'\"\s<>]*)?)['\"]", text)
            links[path] = [(link, False) for link in found]

    for path, found in links.items():
        for link, is_loaded in found:
            report.number += 1
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("data", "javascript"):
                continue
            if parts.scheme or parts.netloc:
                if is_loaded or parts.scheme not in EXTERNAL:
                    report.complain(path, link, "leads out of the manual")
                else:
                    report.external.add(link)
                continue
            target = path
            if parts.path:
                target = (path.parent / urllib.parse.unquote(parts.path)).resolve()
            if not target.is_relative_to(folder):
                report.complain(path, link, "leads out of the manual")
            elif not target.is_file() and target.parent != folder / GALLERY:
                report.complain(path, link, "no such file")
            elif parts.fragment and target in pages:
                anchor = urllib.parse.unquote(parts.fragment)
                if anchor not in pages[target].anchors:
                    report.complain(path, link, "no such anchor")


def heading_anchor(heading):
    """as code hosts make it"""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def text_of_markdown(path):
    """what is not code"""
    return re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)


def anchors_of_markdown(path):
    return {heading_anchor(heading)
            for heading in re.findall(r"^#+ (.*)$", text_of_markdown(path), re.M)}


def check_markdown(path, report):
    text = text_of_markdown(path)
    prose = re.sub(r"`[^`\n]*`", "", text)
    links = re.findall(r"\]\(\s*<?([^)\s>]+)", prose)
    links += re.findall(r"^\[[^\]]+\]:\s*<?([^\s>]+)", prose, re.M)
    links += re.findall(r"<(?:a|img|source)\b[^>]*?\b(?:href|src|srcset)=\"([^\"]+)\"", prose)
    links += re.findall(r"<(https?:[^>]+)>", prose)
    for word in re.findall(r"`([\w.+-]+/[\w./+-]*)`", text):
        if (path.parent / word.split("/")[0]).is_dir() and not word.startswith("build/"):
            links.append(word)
    for link in links:
        report.number += 1
        parts = urllib.parse.urlsplit(link)
        if parts.scheme in EXTERNAL:
            report.external.add(link)
            continue
        target = path.parent / urllib.parse.unquote(parts.path) if parts.path else path
        if not target.exists():
            report.complain(path, link, "no such file")
        elif (parts.fragment and target.suffix == ".md"
              and parts.fragment not in anchors_of_markdown(target)):
            report.complain(path, link, "no such heading")


def main():
    report = Report()
    for argument in sys.argv[1:]:
        path = pathlib.Path(argument).resolve()
        if path.is_dir():
            check_folder(path, report)
        elif path.is_file():
            check_markdown(path, report)
        else:
            report.complain(path, "", "no such file or folder")
    for link in sorted(report.external):
        print("external, not checked:", link)
    print(f"{report.number} links, {len(report.errors)} errors")
    print(*report.errors, sep="\n")
    return 1 if report.errors or report.number == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
