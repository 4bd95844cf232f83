# SPDX-License-Identifier: Apache-2.0
"""Checks of prose for lint_checks.py: long sentences in the manual, and words that make persons of code."""
import re

from lint_files import comments, readLines

MOST_WORDS = 30  # in a sentence of the manual
GENERATED = ('docs/scene.md', 'docs/bibliography.md')
PERSONS = re.compile(r'\b(told|tells|tell|is asked|are asked|asks|does not know|do not know)\b', re.I)
ITEM = re.compile(r'^\s*(?:[-*]|\d+\.)\s+')
OTHER = ('#', '|', '<', '[')  # headings, tables, HTML, definitions of links


def paragraphs(lines):
    """Number of the first line and text of paragraphs and list items; neither code, formulas nor tables."""
    found, fenced, begun = [], False, False
    for number, line in enumerate(lines, 1):
        bare = line.strip()
        fence = bare.startswith('```') or bare.count('$$') % 2 == 1
        fenced ^= fence
        code = line.startswith('    ') and not begun
        if fenced or fence or code or not bare or bare.startswith(OTHER) or '$$' in bare:
            begun = False
            continue
        if not begun or ITEM.match(line):
            found.append([number, ''])
        found[-1][1] += ITEM.sub('', line, count=1).strip() + ' '
        begun = True
    return found


def sentences(text):
    plain = re.sub(r'`[^`]*`|\$[^$]*\$', 'X', text)
    plain = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', plain)
    return re.split(r'(?<=[.!?:;])\s+', plain)


def longSentences(files):
    for file in files:
        if not (file.startswith('docs/') and file.endswith('.md')) or file in GENERATED:
            continue
        for number, text in paragraphs(readLines(file)):
            for sentence in sentences(text):
                words = sentence.split()
                if len(words) > MOST_WORDS:
                    begin = ' '.join(words[:5])
                    yield file, number, None, (
                        f'a sentence of {len(words)} words, at most {MOST_WORDS} are allowed: "{begin} ..."'
                    )


def persons(files):
    """Words that make a person of the code."""
    for file in files:
        if file in GENERATED:
            continue
        prose = paragraphs(readLines(file)) if file.endswith('.md') else [c[:2] for c in comments(file)]
        for number, text in prose:
            found = PERSONS.search(re.sub(r'`[^`]*`|"[^"]*"', '', text))
            if found:
                yield file, number, None, f'"{found[0]}" makes a person of the code: name what happens'
