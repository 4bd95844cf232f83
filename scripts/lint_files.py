# SPDX-License-Identifier: Apache-2.0
"""Files of the tree, their comments and headings, for lint_checks.py and lint_fix.py."""
import functools
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOP_LEVEL = (  # other names than those of dotfiles
    'benchmarks blender cmake core docs examples io parallel python scenes scripts tests viewer '
    'CHANGELOG.md CITATION.cff CMakeLists.txt CMakePresets.json CONTRIBUTING.md Containerfile LICENSE '
    'README.md pyproject.toml setup.py'
).split()
LICENCE = 'SPDX-License-Identifier: Apache-2.0'


def trackedFiles():
    """Paths of all files that git does not ignore; without git, all outside of build/ and out/."""
    git = subprocess.run(
        ['git', 'ls-files', '--cached', '--others', '--exclude-standard'],
        cwd=ROOT,
        text=True,
        capture_output=True,
    )
    if git.returncode == 0 and git.stdout:
        paths = git.stdout.splitlines()
    else:
        paths = [
            os.path.relpath(os.path.join(folder, name), ROOT)
            for folder, _, names in os.walk(ROOT)
            for name in names
        ]
        paths = [path for path in paths if not re.match(r'(build|out|\.git|\.cache)/|.*__pycache__/', path)]
    return sorted({path for path in paths if (ROOT / path).is_file()})


def strangers(files):
    """Files whose first folder, or whose own name at the top level, is not of TOP_LEVEL."""
    for file in files:
        top = file.split('/')[0]
        if not top.startswith('.') and top not in TOP_LEVEL:
            yield file, 1, None, f'{top} does not belong to the top level (TOP_LEVEL of lint_files.py)'


def isCpp(file):
    """True for C++ by any usual ending. The tree uses .cpp and .hpp only, which lint_checks.py demands."""
    return file.endswith(('.cpp', '.hpp', '.c', '.cc', '.cxx', '.h', '.hh', '.hxx', '.inl', '.ipp'))


@functools.lru_cache(None)
def isScript(file):
    """True for CMake, Python and shell files, by name or first line."""
    if file.endswith(('.sh', '.py', '.cmake', 'CMakeLists.txt')):
        return True
    if '.' in pathlib.PurePath(file).name:
        return False
    with open(ROOT / file, 'rb') as stream:
        return re.match(rb'#!.*(sh|python3?)$', stream.readline().strip()) is not None


def licenceLine(file):
    """The line of a file that names its licence, or None for files of other types, which have none."""
    if isCpp(file):
        return f'// {LICENCE}'
    recipe = file.endswith(('.yml', '.yaml', '.def', 'Containerfile'))
    return f'# {LICENCE}' if recipe or isScript(file) else None


@functools.lru_cache(None)
def readLines(file):
    return tuple((ROOT / file).read_text(encoding='utf-8', errors='replace').split('\n'))


TOKENS = re.compile(
    r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'  # raw strings, strings
    r'|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\''  # characters
    r'|(//[^\n]*)|(/\*.*?\*/)',
    re.S,
)  # comments


def withoutComments(text):
    """C++ text with comments and string contents blanked; line breaks are kept."""
    return TOKENS.sub(lambda token: re.sub(r'[^\n]', ' ', token[0]), text)


def cppTexts(file):
    """Yields (line, text) of string literals of several words."""
    text = '\n'.join(readLines(file))
    for token in TOKENS.finditer(text):
        if token[0][0] in 'R"' and ' ' in token[0]:
            yield text.count('\n', 0, token.start()) + 1, token[0]


def cppComments(file):
    text = '\n'.join(readLines(file))
    last = (-1, -1)
    for token in TOKENS.finditer(text):
        if not token[2] or LICENCE in token[2]:
            continue
        number = text.count('\n', 0, token.start()) + 1
        column = token.start() - text.rfind('\n', 0, token.start()) - 1
        alone = not text[token.start() - column : token.start()].strip()
        yield number, token[2].lstrip('/<! '), not (alone and last == (number - 1, column))
        last = (number, column)


def scriptComments(file):
    last = -1
    for number, line in enumerate(readLines(file), 1):
        comment = re.match(r'\s*#(?!!) ?(.*)', line)
        comment = comment or re.search(r'(?:^|\s)# (.*)', re.sub(r'"[^"]*"|\'[^\']*\'', '', line))
        if comment and comment[1] != LICENCE:
            yield number, comment[1], last != number - 1
            last = number


def markdownText(file):
    fenced = False
    for number, line in enumerate(readLines(file), 1):
        fenced ^= line.lstrip().startswith('```')
        if not fenced and not line.startswith('    '):
            yield number, re.sub(r'`[^`]*`|\]\([^)]*\)', '', line), False


def comments(file):
    """Yields (line, text, whether a comment starts here) of a file's comments; of Markdown, its text."""
    if isCpp(file):
        return cppComments(file)
    if isScript(file) or file.endswith('.toml'):
        return scriptComments(file)
    return markdownText(file) if file.endswith('.md') else ()


def headings(lines):
    """Anchors of the headings of a Markdown text, as GitHub makes them."""
    anchors, fenced = set(), False
    for line in lines:
        fenced ^= line.lstrip().startswith('```')
        heading = None if fenced else re.match(r'#+ +(.*?)(?: #+)?$', line)
        if heading:
            text = re.sub(r'\[([^]]*)\]\([^)]*\)', r'\1', heading[1]).strip().lower()
            anchor = re.sub(r'[^\w\- ]', '', text).replace(' ', '-')
            repeated, n = anchor, 0
            while repeated in anchors:
                n += 1
                repeated = f'{anchor}-{n}'
            anchors.add(repeated)
        anchors |= set() if fenced else set(re.findall(r'<a (?:id|name)="([^"]+)"', line))
    return anchors
