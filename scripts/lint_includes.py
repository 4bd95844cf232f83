# SPDX-License-Identifier: Apache-2.0
"""Checks of scripts/lint for includes: their order, and circles among folders. See lint_checks.py.

Each check yields (file, line, key, message).
"""
import pathlib
import re

from lint_files import ROOT, isCpp, readLines

ORDER = 'core/include_order.txt'
INCLUDE = re.compile(r'\s*#\s*(?:include|import)\s*(["<])([^">]+)[">]')
OWN = ('core/', 'parallel/', 'io/', 'python/', 'examples/', 'benchmarks/', 'tests/')


def levels():
    lines = (ROOT / ORDER).read_text().splitlines()
    return [line for line in lines if line and not line.startswith('#')]


def level(order, path):
    fits = [entry for entry in order if path == entry or path.startswith(entry + '/')]
    return order.index(max(fits, key=len)) if fits else None


def includes(files):
    """Yields (file, line, included file) of all includes of the tree."""
    for file in filter(isCpp, files):
        for number, line in enumerate(readLines(file), 1):
            include = INCLUDE.match(line)
            if include and (include[1] == '"' or include[2].startswith(OWN)):
                yield file, number, include[2]


def upwardIncludes(files):
    order = levels()
    for file, number, include in includes(files):
        own, other = level(order, file), level(order, include)
        if own is None or other is None:
            lost = file if own is None else include
            yield file, number, None, f'{lost} is under no entry of {ORDER}'
        elif other > own:
            yield (
                file,
                number,
                f'{file} {include}',
                f'includes {include}: {order[other]} is above {order[own]} ({ORDER})',
            )


def leaf(file):
    """The folder of a file in core/ or io/, else None."""
    return str(pathlib.PurePath(file).parent) if file.startswith(('core/', 'io/')) else None


def topFolder(file):
    """The folder of core/ or io/ that a file is below, else None."""
    parts = file.split('/')
    return '/'.join(parts[:2]) if parts[0] in ('core', 'io') and len(parts) > 2 else None


def reachable(graph, start):
    """Folders that a folder includes, directly or through others."""
    found, waiting = set(), [start]
    while waiting:
        for folder in graph.get(waiting.pop(), {}).keys() - found:
            found.add(folder)
            waiting.append(folder)
    return found


def circles(files):
    """First include of each step of a circle among folders, which single files in the order would hide."""
    for unit in (leaf, topFolder):
        graph = {}
        for file, number, include in includes(files):
            own, other = unit(file), unit(include)
            if own and other and own != other:
                graph.setdefault(own, {}).setdefault(other, (file, number))
        reach = {folder: reachable(graph, folder) for folder in graph}
        for own, others in graph.items():
            for other, (file, number) in others.items():
                if own in reach.get(other, ()):
                    yield file, number, None, f'{own} includes {other}, which includes {own} in a circle'
