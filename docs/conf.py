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
