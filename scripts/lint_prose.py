# SPDX-License-Identifier: Apache-2.0
"""Checks of prose for lint_checks.py: long sentences in the manual, and words that make persons of code."""
import re

from lint_files import comments, cppTexts, isCpp, readLines, withoutComments

MOST_WORDS = 30  # in a sentence of the manual
MOST_MANUAL_WORDS = 20000
GENERATED = ('docs/scene.md', 'docs/bibliography.md')
GENERATED_PAGES = ('docs/reference/python_api.md', 'docs/validation/accuracy.md', 'docs/performance.md')
TEMPLATES = ('benchmarks/accuracy/text.md', 'benchmarks/performance/text.md')  # their tags look like words
PERSONS = re.compile(
    r'\b(told|tells?|wants?|is asked|are asked|asks|knows|do(es)? not know'
    r'|nobody|somebody|anybody|everyone|whom)\b',
    re.I,
)
# Words of texts, parts of names, and their successors in the glossary.
RETIRED = (
    (r'book(s|ed|ing)?|bookkeeping', None, 'record, energy budget or ledger'),
    (r'(bring|send|go)s? home|(brought|sent) home', r'(bring|send)\w*Home\b', 'redistribute'),
    (r'ballots?|votes?', 'Ballot', 'time-step reduction'),
    (r'(?<!-)fillings?', 'Filling', 'relative density'),
    (r'crowding', None, 'concentration gradient, or surplus particles'),
    (r'draping', 'meetContinuum', 'coupling or contact'),
    (r'steadying', 'pressureKick', 'divergence pressure, pressure impulse'),
    (None, 'surfaceCover|surfacePull|surfaceDraw', 'colour and the derivatives of its energy'),
    (r'relink(s|ed|ing)?', 'relink[A-Z]', 'rebuild bonds'),
    (r'bared', 'coverBare|listBare', 'exposed'),
    (r'rags?|fins|specks?|twins|lumps|crumbs?', None, 'detached surfels, spurs, isolated colours, fragments'),
    (r'leap(s|t|ed)?(?!-frog)', None, 'project to the iso-surface'),
    (r'calm(s|ed|er)?', None, 'at rest, rest time'),
    (r'champions?', 'Champion', 'local maximum'),
    (None, r'keepOut\b|keepEnclosed|keepVolume', 'projectOutOfObstacles, attachEnclosed, enforceVolume'),
    (
        None,
        r'(?i:near_?gaps|gap_?ceilings?|film_?room|open_?region|mixed_?bins)',
        'gap detection, active set, ...',
    ),
    (r'solid slots?', '[sS]olidSlot', 'solid index'),
    (r'anchor(s|ed|ing) (particles?|vert(ex|ices))', None, 'constraint'),
    (
        r'(?<!shrink-)wrap (forces?|targets?|pressure)',
        r'(?<![Ss]hrink)Wrap(Body|Cell|Force|Kind|Target)\b',
        'shrink-wrap',
    ),
    (None, r'(most|more)Halvings|[.>]halvings', 'backoff'),
    (r'wanted volumes?', 'wantedVolume', 'target volume'),
    (r'standoffs?', None, 'contact offset'),
    (r'kinds of bod(y|ies)', r'bodyKinds?\b', 'body type'),
    (None, 'homeTurn', 'rest orientation'),
    (None, 'workingLoad|underWay', 'impulse in flight'),
    (r'alarms?|good states?|patience', 'goodState', 'failure, snapshot, rollback, backoff'),
    (r'sunken', None, 'interpenetration'),
    (None, 'takeStock', 'initializeForces'),
    (
        r'misfits?',
        '[lL]etGo|giveUnderWay|closeLeavers|noteHolds|noteIdle|sayRelaxed',
        'validate, remove, record, ...',
    ),
    (r'inbox', 'RowCourier|WordList|Inbox', 'scatter back, byte stream, receive buffer'),
    (r'grips?', None, 'strain bound, or largest rate of friction'),
    (r'newcomers?|judges?|excellent|missed by|that paid', None, 'a property, without praise and readers'),
)
PARTS = ('|'.join(filter(None, (words and rf'(?i:\b(?:{words})\b)', names))) for words, names, _ in RETIRED)
WORDS = re.compile('|'.join(f'(?P<w{k}>{part})' for k, part in enumerate(PARTS)))
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
    return re.split(r'(?<=[.!?])\s+', plain)


def longSentences(files):
    for file in files:
        if not file.endswith('.md') or file in GENERATED + TEMPLATES:
            continue
        for number, text in paragraphs(readLines(file)):
            for sentence in sentences(text):
                words = sentence.split()
                if len(words) > MOST_WORDS:
                    begin = ' '.join(words[:5])
                    yield file, number, None, (
                        f'a sentence of {len(words)} words, at most {MOST_WORDS} are allowed: "{begin} ..."'
                    )


def manualWords(file):
    """Number of words of a page, without code, formulas, tables and headings."""
    texts = (text for _, text in paragraphs(readLines(file)))
    return sum(len(re.sub(r'`[^`]*`|\$[^$]*\$', '', text).split()) for text in texts)


def longManual(files):
    """The manual, if its pages that are written by hand have too many words."""
    pages = [file for file in files if file.startswith('docs/') and file.endswith('.md')]
    total = sum(manualWords(file) for file in pages if file not in GENERATED + GENERATED_PAGES)
    if total > MOST_MANUAL_WORDS:
        yield 'docs', 1, None, f'the manual has {total} words, at most {MOST_MANUAL_WORDS} are allowed'


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


def retiredWords(files):
    """Words that have a successor in docs/developer/glossary.md, in texts, messages and names of C++."""
    for file in files:
        if file in GENERATED or file.startswith(('scripts/lint', 'tests/lint/')):
            continue
        texts = [c[:2] for c in comments(file)]
        if isCpp(file):
            texts += cppTexts(file)
            texts += enumerate(withoutComments('\n'.join(readLines(file))).split('\n'), 1)
        for number, text in texts:
            found = WORDS.search(re.sub(r'`[^`]*`', '', text))
            if found:
                instead = RETIRED[int(found.lastgroup[1:])][2]
                yield file, number, None, f'"{found[0]}" is retired: {instead} (docs/developer/glossary.md)'
