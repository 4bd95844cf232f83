# SPDX-License-Identifier: Apache-2.0
"""Corrections of scripts/lint --fix, which runs clang-format and black afterwards:

- the first line, after "#!", names the licence;
- fields of tables (`Column<...> name{...}`, between // clang-format off and on) take one line, or break
  before their description;
- headings of sections (`// ---- fluid -----`) end at the last column;
- a comment after a long line of C++ goes above it, if there is room;
- comments of scripts and arguments of CMake commands are wrapped.
"""
import re

from lint_checks import MOST_COLUMNS
from lint_files import ROOT, TOKENS, isCpp, isScript, licenceLine, readLines, trackedFiles

LEAST_ROOM = 44  # columns for a comment behind a line


def shortHeading(line):
    heading = re.match(r'(\s*// -{2,} .*?) -{3,}$', line)
    if not heading or len(line) <= MOST_COLUMNS:
        return line
    return heading[1] + ' ' + '-' * max(4, MOST_COLUMNS - len(heading[1]) - 1)


def trailingComments(text):
    """Line numbers, from 0, and columns of comments after code; raw strings are skipped."""
    found = {}
    for token in TOKENS.finditer(text):
        begin = text.rfind('\n', 0, token.start()) + 1
        if token[2] and text[begin : token.start()].strip():
            found[text.count('\n', 0, token.start())] = token.start() - begin
    return found


COLUMN = re.compile(
    r'(  (?:Guest)?Column<.*> \w+{(?:\*this|table), "[^"]*", "[^"]*", Keep::\w+,) ' r'"(.*)"(, Rows::\w+)?};$'
)


def fields(lines):
    """The lines with the fields of tables broken."""
    fixed, parts = [], []
    for line in lines:
        parts = parts + [line.strip()] if parts else [line] if re.match(r'  (Guest)?Column<', line) else []
        if not parts:
            fixed.append(line)
            continue
        if not line.endswith('};'):
            continue
        whole = re.sub(r'" "(?=[^,])', '', ' '.join(parts)).replace('{ *this', '{*this')
        column = COLUMN.match(whole)
        fixed += field(*column.groups()) if column and len(whole) > MOST_COLUMNS else [whole]
        parts = []
    return fixed


def field(head, text, rows):
    broken, indent, end = [head], ' ' * 6, f'"{rows or ""}}};'
    while len(indent) + 1 + len(text) + len(end) > MOST_COLUMNS:
        space = text.rfind(' ', 0, MOST_COLUMNS - len(indent) - 2)
        broken.append(f'{indent}"{text[:space + 1]}"')
        text = text[space + 1 :]
    return [*broken, f'{indent}"{text}{end}']


def fixCpp(lines):
    lines = fields(lines)
    trailing = trailingComments('\n'.join(lines))
    fixed = []
    for number, line in enumerate(lines):
        line = shortHeading(line)
        column = trailing.get(number)
        code = line[:column].rstrip() if column else ''
        movable = column and len(line) > MOST_COLUMNS and len(code) > MOST_COLUMNS - LEAST_ROOM
        if movable and not re.match(r'\s*(}|else\b|#)', code) and not re.search(r'NOLINT|clang-format', line):
            indent = code[: len(code) - len(code.lstrip())]
            comment = re.sub(r'^///<', '///', line[column:])
            fixed += [indent + comment, code]
        else:
            fixed.append(line)
    return fixed


def wrapped(prefix, text):
    """The first line of the text, and the rest."""
    end = text.rfind(' ', 0, MOST_COLUMNS - len(prefix) + 1)
    return (text, '') if len(prefix + text) <= MOST_COLUMNS or end <= 0 else (text[:end], text[end + 1 :])


def fixScript(lines):
    fixed, carried, before = [], '', ''
    for line in lines:
        comment = re.match(r'(\s*# )(\S.*)$', line)
        if carried and not (comment and comment[1] == before and re.match('[a-z(]', comment[2])):
            fixed += wrapComment(before, carried)
            carried = ''
        if not comment:
            fixed.append(line)
            continue
        before, text = comment[1], (carried + ' ' + comment[2]).strip()
        first, carried = wrapped(before, text)
        fixed.append(before + first)
    return fixed


def wrapComment(prefix, text):
    lines = []
    while text:
        first, text = wrapped(prefix, text)
        lines.append(prefix + first)
    return lines


CMAKE_WORDS = re.compile(r'(?:[^\s"]|"(?:\\.|[^"\\])*")+')


def fixCMake(lines):
    fixed = []
    for line in fixScript(lines):
        if len(line) <= MOST_COLUMNS or line.lstrip().startswith('#') or line.count('"') % 2:
            fixed.append(line)
            continue
        indent = line[: len(line) - len(line.lstrip())]
        words = CMAKE_WORDS.findall(line)
        if '#' in words:  # the comment behind a command
            fixed += wrapComment(indent + '# ', ' '.join(words[words.index('#') + 1 :]))
            words = words[: words.index('#')]
        behind = indent + '  ' if re.match(r'\w+\(', words[0]) else indent  # else arguments continue
        current = indent + words[0]
        for word in words[1:]:
            if len(current) + 1 + len(word) > MOST_COLUMNS:
                fixed.append(current)
                current = behind + word
            else:
                current += ' ' + word
        fixed.append(current)
    return fixed


def isCMake(file):
    return file.endswith(('.cmake', 'CMakeLists.txt'))


def withLicence(file, lines):
    expected = licenceLine(file)
    if expected in lines[:2]:
        return lines
    first = 1 if lines[0].startswith('#!') else 0
    return [*lines[:first], expected, *lines[first:]]


def main():
    for file in trackedFiles():
        fix = fixCpp if isCpp(file) else fixCMake if isCMake(file) else fixScript if isScript(file) else list
        lines = readLines(file) if licenceLine(file) else ()
        fixed = withLicence(file, fix(lines)) if lines else []
        if fixed != list(lines):
            (ROOT / file).write_text('\n'.join(fixed), encoding='utf-8')


if __name__ == '__main__':
    main()
