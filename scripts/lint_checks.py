# SPDX-License-Identifier: Apache-2.0
"""Text checks of scripts/lint that clang-format, clang-tidy, black and codespell do not cover.

    lint_checks.py            prints `file:line: message` for each finding; exit status 1 if there are any
    lint_checks.py --record   rewrites the lists scripts/lint_known_*.txt from the findings

A list of known findings may only shrink: a finding that is not listed is an error, and so is an entry
without a finding.
"""
import argparse
import ast
import pathlib
import re
import sys

from lint_files import (
    ROOT,
    comments,
    headings,
    isCpp,
    isScript,
    licenceLine,
    readLines,
    strangers,
    trackedFiles,
    withoutComments,
)
from lint_includes import circles, upwardIncludes
from lint_names import unknownMembers, unknownPapers, unknownTests, unstyledTests
from lint_prose import longManual, longSentences, persons, retiredWords

MOST_COLUMNS = 110
MOST_FILES = 30
MOST_LINES = 70
# beside C++ and scripts
WRAPPED = ('.toml', '.js', '.mjs', '.css', '.html', '.yml', '.yaml', '.def', '.cff', '.in', '.pyi')
WRAPPED += ('Containerfile',)
SOURCES = ('.cpp', '.hpp', '.py', '.sh')


def known(name):
    return ROOT / 'scripts' / f'lint_known_{name}.txt'


# ---- checks: each yields (file, line, key, message); lists of known findings hold the key ----


def longLines(files):
    for file in files:
        if not (isCpp(file) or isScript(file) or file.endswith(WRAPPED)):
            continue
        for number, line in enumerate(readLines(file), 1):
            if len(line) > MOST_COLUMNS and not re.search(r'https?://\S{60}', line):
                yield file, number, None, f'{len(line)} columns, at most {MOST_COLUMNS} are allowed'


def otherEndings(files):
    for file in files:
        if isCpp(file) and not file.endswith(('.cpp', '.hpp')):
            yield file, 1, None, 'C++ files end in .cpp or .hpp'


def mergeMarkers(files):
    for file in files:
        for number, line in enumerate(readLines(file), 1):
            if line.startswith(('<<<<<<< ', '>>>>>>> ')):
                yield file, number, None, 'a marker of a merge: choose one of both texts'


def withoutLicence(files):
    for file in files:
        expected = licenceLine(file)
        if expected and expected not in readLines(file)[:2]:
            yield file, 1, 'files', f'no line "{expected}" at the top: run scripts/lint --fix'


def fullFolders(files):
    count = {}
    for file in files:
        if file.endswith(SOURCES):
            folder = str(pathlib.PurePath(file).parent)
            count[folder] = count.get(folder, 0) + 1
    for folder, n in count.items():
        for _ in range(n - MOST_FILES):
            yield folder, 1, folder, f'{n} source files, at most {MOST_FILES} are allowed'


CONTROL = re.compile(r'(^|[^\w])(if|for|while|switch|catch|do|else|try|return)\s*(\(|constexpr|$)')

TYPE = re.compile(
    r'(template\s*<.*>\s*)?(typedef |inline |static |constexpr |const )*' r'(struct|class|union|enum)\b', re.S
)


def kindOfBlock(statement, inside):
    """Kind of block that a brace opens, from the text before it: namespace, type, function or block."""
    text = re.sub(r'^(\s*#.*\n)+', '', statement).strip()
    if inside in ('function', 'block'):
        return 'block'
    if re.search(r'\bnamespace\b|^extern "', text):
        return 'namespace'
    if TYPE.match(text) and not re.search(r'\)\s*(const|noexcept|override)?$', text):
        return 'type'
    if '(' in text and not CONTROL.match(text) and not re.search(r'(^|[^=!<>+])=\s*(\[.*)?$', text, re.S):
        return 'function'
    return 'block'


def cppFunctions(lines):
    """Yields (name, first line, lines) of each function in C++ text."""
    stack, statement, start = [], '', 0
    text = withoutComments('\n'.join(lines))
    for number, line in enumerate(text.split('\n'), 1):
        if line.lstrip().startswith('#') or line.endswith('\\'):
            continue
        for c in line + '\n':
            if c in '{}' or (c == ';' and not (stack and stack[-1][0] == 'function')):
                if c == '{':
                    kind = kindOfBlock(statement, stack[-1][0] if stack else 'namespace')
                    stack.append((kind, start or number, statement))
                elif c == '}' and stack:
                    kind, first, head = stack.pop()
                    if kind == 'function':
                        name = re.search(
                            r'(TEST\w*\(.*\)|[\w~:]+(?=\s*\()|operator[^\s(]+)',
                            re.sub(r'__attribute__\s*\(\(.*?\)\)|alignas\(.*?\)', '', head),
                        )
                        yield name[1] if name else '?', first, number - first + 1
                statement, start = '', 0
            else:
                if not start and not c.isspace():
                    start = number
                statement += c


def pythonFunctions(lines):
    for node in ast.walk(ast.parse('\n'.join(lines))):
        if isinstance(node, ast.FunctionDef):
            yield node.name, node.lineno, node.end_lineno - node.lineno + 1


def longFunctions(files):
    for file in files:
        functions = cppFunctions if isCpp(file) else pythonFunctions if file.endswith('.py') else None
        for name, number, lines in functions(readLines(file)) if functions else []:
            if lines > MOST_LINES:
                yield (
                    file,
                    number,
                    f'{file} {name}',
                    f'{name} has {lines} lines, at most {MOST_LINES} are allowed',
                )


CLAUSE = re.compile(r'\W*(of|what|those|who)\b', re.I)
DECIMAL = re.compile(r'(?<![\w.)\]/*}"\'-])-?\.\d')


def wording(files):
    for file in files:
        for number, text, starts in comments(file):
            begin = CLAUSE.match(text) if starts else None
            if begin:
                yield file, number, file, f'a comment begins with "{begin[1]}": name the thing, with a verb'
            if DECIMAL.search(re.sub(r'`[^`]*`', '', text)):
                yield file, number, file, 'a decimal without its leading zero'


LINK = re.compile(
    r'\]\(<?([^()\s<>]+)>?(?: "[^"]*")?\)'  # [text](target)
    r'|^ {0,3}\[[^\]]+\]: *<?([^\s<>]+)'  # [label]: target
    r'|<[^>]*\b(?:src|href)="([^"]+)"'  # HTML
)
GALLERY = re.compile(r'docs/gallery/(\w+)\.html')  # pages that scripts/gallery makes from scenes
LABEL = re.compile(r'^ {0,3}\[([^\]]+)\]:')
LABELLED = re.compile(r'\[([^\[\]]+)\]\[([^\[\]]*)\]')
# These pages are generated from benchmarks/*/text.md.
PAGES = {
    'benchmarks/accuracy/text.md': 'docs/validation/page.md',
    'benchmarks/performance/text.md': 'docs/page.md',
}


def proseLines(file):
    """Yields (line, text) of a Markdown file without code."""
    fenced = False
    for number, line in enumerate(readLines(file), 1):
        fenced ^= line.lstrip().startswith('```')
        if not fenced:
            yield number, re.sub(r'`[^`]*`', '`', line)


def deadLinks(files):
    listed = set(files)
    folders = {str(parent) for file in files for parent in pathlib.PurePath(file).parents}
    anchors = {file: headings(readLines(file)) for file in files if file.endswith('.md')}
    for file in anchors:
        for number, line in proseLines(file):
            for target in (next(filter(None, found)) for found in LINK.findall(line)):
                if re.match(r'[a-z]+:', target):
                    continue
                path, _, anchor = target.partition('#')
                there = relative(PAGES.get(file, file), path) if path else file
                page = GALLERY.fullmatch(there)
                if page and any(
                    name.startswith('scenes/') and name.endswith(f'/{page[1]}.toml') for name in listed
                ):
                    continue
                if there not in listed and there not in folders:
                    yield file, number, None, f'dead link: there is no {there}'
                elif anchor and there in anchors and anchor not in anchors[there]:
                    yield file, number, None, f'dead link: {there} has no heading #{anchor}'


def unknownLabels(files):
    """Links `[text][label]` without a definition of their label."""
    for file in (file for file in files if file.endswith('.md')):
        lines = list(proseLines(file))
        labels = {label[1].lower() for label in (LABEL.match(line) for _, line in lines) if label}
        for number, line in lines:
            for text, label in LABELLED.findall(re.sub(r'\$[^$]*\$', '', line)):
                if (label or text).lower() not in labels:
                    yield file, number, None, f'dead link: nothing defines [{label or text}]'


def relative(file, path):
    parts = []
    for part in [*pathlib.PurePath(file).parent.parts, *pathlib.PurePath(path).parts]:
        if part == '..' and parts:
            parts.pop()
        elif part != '.':
            parts.append(part)
    return '/'.join(parts) or '.'


REFERENCE = re.compile(
    r'(?<![\w/.$}<>*-])(?:\.\./)*(?:[\w-]+/)*[\w-]+\.(?:md|hpp|cpp|py|sh|\*)(?!\w|\.\w)'
    r'|(?<![\w/.$}<>*-])docs/[\w/.-]*\w'
)
SYSTEM = ('mpi', 'immintrin', 'boost', 'Eigen', 'fmt', 'gtest', 'catalyst')  # headers of other projects


def deadReferences(files):
    ends = set()
    for file in files:
        for name in [file, *map(str, list(pathlib.PurePath(file).parents)[:-1])]:
            parts = name.split('/')
            ends |= {'/'.join(parts[i:]) for i in range(len(parts))}
    ends |= {re.sub(r'\.\w+$', '.*', end) for end in ends}
    for file in files:
        if file.endswith('.md'):
            continue
        for number, text, _ in comments(file):
            for name in REFERENCE.findall(text):
                if name.startswith(SYSTEM) or 'NAME' in name or name.lstrip('./') in ends:
                    continue
                yield file, number, f'{file} {name}', f'the comment names {name}, which does not exist'


# ---- lists of known findings ----


def readKnown(name):
    """Entries of a list with their counts and the reasons behind them: `COUNT KEY  # REASON`."""
    entries = {}
    path = known(name)
    for number, line in enumerate(path.read_text().splitlines() if path.exists() else [], 1):
        if line and not line.startswith('#'):
            entry, _, reason = line.partition('  # ')
            count, _, key = entry.strip().partition(' ')
            entries[key] = (int(count), number, reason)
    return entries


def newFindings(name, findings):
    """Findings beyond those that are listed, and entries of the list that are too large."""
    entries, found = readKnown(name), {}
    for finding in findings:
        found.setdefault(finding[2], []).append(finding)
    for key, group in found.items():
        allowed = entries.get(key, (0,))[0] if key else 0
        if len(group) > allowed:
            note = f' [{name}: {len(group)} in all, {allowed} known]' if allowed else f' [{name}]'
            yield from dict.fromkeys((file, line, message + note) for file, line, _, message in group)
    for key, (count, number, _) in entries.items():
        if len(found.get(key, [])) < count:
            yield (
                f'scripts/lint_known_{name}.txt',
                number,
                f'"{key}" occurs {len(found.get(key, []))} times: '
                f'lower its count, or delete the line [{name}]',
            )


def record(name, findings, about):
    entries, count = readKnown(name), {}
    for _, _, key, _ in findings:
        if key:
            count[key] = count.get(key, 0) + 1
    lines = [f'# {line}' for line in about.split('\n')]
    for key in sorted(count):
        reason = entries[key][2] if key in entries else 'to be split' if name == 'functions' else ''
        lines.append(f'{count[key]} {key}' + (f'  # {reason}' if reason else ''))
    if count:
        known(name).write_text('\n'.join(lines) + '\n')
    else:
        known(name).unlink(missing_ok=True)


SHRINKS = 'The list may only shrink (scripts/lint).'
CHECKS = {
    'licence': (withoutLicence, f'Files without an SPDX line: their count. {SHRINKS}'),
    'merge_markers': (mergeMarkers, None),
    'long_lines': (longLines, None),
    'endings': (otherEndings, None),
    'includes': (
        upwardIncludes,
        f'Includes against core/include_order.txt: count, file and include. {SHRINKS}',
    ),
    'circles': (circles, None),
    'folders': (fullFolders, f'Source files above {MOST_FILES} in a folder: count and folder. {SHRINKS}'),
    'functions': (
        longFunctions,
        f'Functions of more than {MOST_LINES} lines: count, file, function and reason. {SHRINKS}',
    ),
    'wording': (
        wording,
        'Comments that begin with of, what, those or who, and decimals without a leading\n'
        f'zero: count and file. {SHRINKS}',
    ),
    'top_level': (strangers, None),
    'sentences': (longSentences, None),
    'manual': (longManual, None),
    'persons': (persons, None),
    'words': (retiredWords, None),
    'links': (deadLinks, None),
    'labels': (unknownLabels, None),
    'papers': (unknownPapers, None),
    'members': (unknownMembers, None),
    'tests': (unknownTests, None),
    'test_names': (unstyledTests, None),
    'references': (
        deadReferences,
        f'References in comments to files that do not exist: count, file and name. {SHRINKS}',
    ),
}


def main():
    parser = argparse.ArgumentParser(description='Checks of text for scripts/lint.')
    parser.add_argument('--record', action='store_true', help='rewrite the lists of known findings')
    options = parser.parse_args()
    files = trackedFiles()
    failing = set()
    for name, (check, about) in CHECKS.items():
        if name == 'circles' and 'includes' in failing:
            continue  # one upward include closes many circles
        findings = list(check(files))
        if options.record and about:
            record(name, findings, about)
        for file, line, message in newFindings(name, findings):
            failing.add(name)
            print(f'{file}:{line}: {message}')
    return 1 if failing else 0


if __name__ == '__main__':
    sys.exit(main())
