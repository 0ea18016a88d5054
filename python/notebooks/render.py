#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the page Notebooks of the manual: render.py PAGE FIGURES NOTEBOOK...

Writes notebooks with their results, as Jupyter leaves them, to the file PAGE in the form of Doxygen, and
their pictures to the folder FIGURES.
"""

import base64
import json
import pathlib
import re
import sys

HEAD = r"""// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

namespace CGAL {
namespace Restricted_laplacian_3 {

/*!
\page RL_notebooks Notebooks

\cgalAutoToc

The notebooks of `python/notebooks`, with what they print and draw. `scripts/run_notebooks.sh` has run them.
"""
TAIL = """*/

} // namespace Restricted_laplacian_3
} // namespace CGAL
"""


def code(text, kind):
    return f"\\code{{{kind}}}\n{text}\n\\endcode\n"


def prose(text, name):
    """Markdown of a cell: a title becomes a section."""
    text = re.sub(r"^# (.*)$", rf"\\section RL_notebook_{name} \1", text, flags=re.M)
    text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
    return re.sub(r"\$(.+?)\$", r"\\f$\1\\f$", text) + "\n"


def outputs_of(cell):
    """Texts, joined, and pictures."""
    text, pictures = "", []
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            text += "".join(output["text"])
            continue
        data = output.get("data", {})
        if "image/png" in data:
            pictures.append(base64.b64decode(data["image/png"]))
        elif "text/plain" in data:
            text += "".join(data["text/plain"]) + "\n"
    return text.strip("\n"), pictures


def main():
    page, figures = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    parts = [HEAD]
    for file in sys.argv[3:]:
        name = pathlib.Path(file).stem
        number = 0
        for cell in json.loads(pathlib.Path(file).read_text(encoding="utf-8"))["cells"]:
            source = "".join(cell["source"])
            if cell["cell_type"] == "markdown":
                parts.append(prose(source, name))
                continue
            parts.append(code(source, ".py"))
            text, pictures = outputs_of(cell)
            if text:
                parts.append(code(text, ".unparsed"))
            for picture in pictures:
                number += 1
                label = f"notebook_{name}_{number}"
                (figures / f"{label}.png").write_bytes(picture)
                parts.append(f"\\cgalFigureBegin{{{label},{label}.png}}\n"
                             f"\\cgalFigureCaptionBegin{{{label}}}\nWhat the code above draws.\n"
                             "\\cgalFigureCaptionEnd\n\\cgalFigureEnd\n")
    page.write_text("\n".join(parts) + TAIL, encoding="utf-8")


if __name__ == "__main__":
    main()
