# SPDX-License-Identifier: Apache-2.0
"""Sphinx reads this file to build the manual (scripts/docs)."""
import re
from pathlib import Path

cmake = (Path(__file__).parent.parent / "CMakeLists.txt").read_text(encoding="utf-8")
project = "thaw"
version = release = re.search(r"project\(thaw[^)]*?VERSION\s+([0-9.]+)", cmake).group(1)
author = "the authors of thaw"
copyright = author
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
exclude_patterns = []
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4  # links to sections, as files.md#frames
html_theme = "furo"
html_title = f"thaw {version}"


bibliography = (Path(__file__).parent / "bibliography.md").read_text(encoding="utf-8")
keys = re.findall(r"^\| ([A-Z][A-Za-z0-9]*) \|", bibliography, re.M)


def setup(app):
    """Links keys such as [M05] to the bibliography, and drops links to gallery pages that are not made."""

    def link_keys(_, name, source):
        if name != "bibliography":
            page = "../" * name.count("/") + "bibliography.md"
            source[0] += "\n\n" + "".join(f"[{key}]: {page}\n" for key in keys)

    def keep_or_drop(link):
        return link[0] if (Path(app.outdir) / link[1]).exists() else link[2]

    def drop_missing(_, name, source):
        if name == "gallery":
            source[0] = re.sub(r'<a href="(gallery/[^"]+)">([^<]*)</a>', keep_or_drop, source[0])

    app.connect("source-read", link_keys)
    app.connect("source-read", drop_missing)
    # The pages may change while the text does not.
    app.connect("env-get-outdated", lambda *_: ["gallery"])
