# SPDX-License-Identifier: Apache-2.0
"""Checks of scripts/lint that names in comments and pages exist: papers, members, tests. See lint_checks.py.

Each check yields (file, line, key, message).
"""
import re

from lint_files import comments, isCpp, readLines, withoutComments

BIBLIOGRAPHY = 'docs/bibliography.md'
STABILITY = 'docs/validation/stability.md'

KEY = re.compile(r'(?<![\w.#/@-])[A-Z]{1,5}\d\d(?!\w|\.\d)')
NO_KEYS = ('CLI11', 'F32', 'F64')  # a package and number formats of this form
AUTHOR = re.compile(
    r"(?P<names>(?:(?:de|van|von|Le) )*[^\W\d_a-z][\w'’-]+"
    r"(?:(?:, | and | & )[^\W\d_a-z][\w'’-]+)*(?: et al\.)?),? \(?(?P<year>1[89]\d\d|20\d\d)\b"
)
MONTHS = re.compile(r'(Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)[a-z]*$')
ROWS = re.compile(r'\bstability(?:\.md,)? rows? (\d+)(?: and (\d+))?')


def plain(name):
    """A name without umlauts and accents that are spelt in two ways."""
    return name.lower().translate({ord('ü'): 'ue', ord('ö'): 'oe', ord('ä'): 'ae', ord('é'): 'e'})


def bibliography(files):
    """References by key."""
    lines = readLines(BIBLIOGRAPHY) if BIBLIOGRAPHY in files else ()
    rows = (re.match(r'\| (\w+) \| (.*) \|$', line) for line in lines)
    return {row[1]: plain(row[2]) for row in rows if row and row[1] != 'key'}


def texts(files):
    """Yields (file, line, text) of comments and pages, without code."""
    for file in files:
        if file in (BIBLIOGRAPHY, 'CHANGELOG.md'):
            continue
        for number, text, _ in comments(file):
            yield file, number, re.sub(r'`[^`]*`', '', text)


def isListed(references, cited):
    """True if a reference has the year, and the first author's name that a text cites."""
    name = re.split(r', | and | & | et al', cited['names'])[0]
    return any(plain(name) in text and cited['year'] in text for text in references.values())


def stabilityRows(files):
    lines = readLines(STABILITY) if STABILITY in files else ()
    return {row[1] for row in (re.match(r'\| (\d+) \|', line) for line in lines) if row}


def unknownPapers(files):
    references, rows = bibliography(files), stabilityRows(files)
    for file, number, text in texts(files):
        for key in KEY.findall(text):
            if key not in references and key not in NO_KEYS:
                yield file, number, None, f'{BIBLIOGRAPHY} has no key {key}'
        for cited in AUTHOR.finditer(text):
            if MONTHS.match(cited['names']):
                continue
            if isCpp(file):
                yield file, number, None, f'cites "{cited[0]}": name its key in {BIBLIOGRAPHY}'
            elif not isListed(references, cited):
                yield file, number, None, f'{BIBLIOGRAPHY} does not list "{cited[0]}"'
        for cited in ROWS.finditer(text):
            for row in set(filter(None, cited.groups())) - rows:
                yield file, number, None, f'{STABILITY} has no row {row}'


TYPE = re.compile(r'\b(?:struct|class|enum|union|using)\s+(?:class\s+)?(?:alignas\([^)]*\)\s*)?(\w+)')
BASES = re.compile(r'\b(?:struct|class)\s+(\w+)(?:\s+final)?\s*:\s*([^{;]+)\{')
MEMBER = re.compile(r'(?<![\w:])([A-Z]\w*)::~?(\w+)')
FOREIGN = ('Eigen', 'PNG', 'CLI', 'MPI', 'HDF5', 'ZLIB')  # namespaces of other projects


def unknownMembers(files):
    """Members `Type::member` whose type no file declares, or that no file with it or a base contains."""
    declared, words, bases = {}, {}, {}
    for file in filter(isCpp, files):
        code = withoutComments('\n'.join(readLines(file)))
        words[file] = frozenset(re.findall(r'\w+', code))
        for name in TYPE.findall(code):
            declared.setdefault(name, set()).add(file)
        for name, above in BASES.findall(code):
            bases.setdefault(name, set()).update(re.findall(r'\w+', above))
    for name, above in bases.items():
        for base in above & declared.keys():
            declared.setdefault(name, set()).update(declared[base])
    for file in files:
        for number, text, _ in comments(file):
            for owner, member in MEMBER.findall(text):
                if owner in FOREIGN or any(member in words[where] for where in declared.get(owner, ())):
                    continue
                yield file, number, None, f'{owner}::{member} does not exist'


TEST = re.compile(r'^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)')
CITED_TEST = re.compile(r'(?<![\w./])([A-Z][A-Za-z]+)\.([A-Z]\w+)(?![\w/(])|\b(Row\d\d[A-Z]\w*)')
NO_TEST = re.compile(r'[A-Z]+\.|\w+\.(md|txt|cpp|hpp)$')  # files


def testNames(files):
    """Yields (file, line, suite, name) of GoogleTest's tests."""
    for file in files:
        if file.startswith('tests/') and isCpp(file):
            for number, line in enumerate(readLines(file), 1):
                test = TEST.match(line)
                if test:
                    yield file, number, test[1], test[2]


def unstyledTests(files):
    for file, number, suite, name in testNames(files):
        for word in (suite, name):
            if not re.fullmatch(r'[A-Z][A-Za-z0-9]*', word):
                yield file, number, None, f'test {suite}.{name}: {word} is not in CapitalisedWords'


def unknownTests(files):
    """Tests `Suite.Name` that do not exist, and those of rows of the stability page."""
    listed = {(suite, name) for _, _, suite, name in testNames(files)}
    names = {name for _, name in listed}
    for file in files:
        lines = readLines(file) if file.endswith('.md') else None
        source = enumerate(lines, 1) if lines else ((number, text) for number, text, _ in comments(file))
        for number, text in source:
            for cited in CITED_TEST.finditer(text):
                known = cited[3] in names if cited[3] else (cited[1], cited[2]) in listed
                if not known and not NO_TEST.match(cited[0]):
                    yield file, number, None, f'test {cited[0]} does not exist'
