# SPDX-License-Identifier: Apache-2.0
"""Runs clang-tidy for scripts/lint, two at a time.

    lint_tidy.py BUILD ALL|COMMIT     checks all sources, or those that differ from COMMIT, committed or not

A changed header is checked through the source of the same name, or a near one that includes it.
ALL checks the sources of a folder as one, since most of the time goes into headers that they share. Where
their names collide, each is checked alone.
"""
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

from lint_files import ROOT, isCpp, readLines, trackedFiles

AT_ONCE = 2
MOST_TOGETHER = 12  # sources of a group
MOST_CHANGED = 16  # limit of changed sources: three minutes on two cores
CLANG_TIDY = os.environ.get('CLANG_TIDY', 'clang-tidy-14')
# The configuration is named, since sources of groups are outside of the tree.
CONFIGURED = (f'--config-file={ROOT}/.clang-tidy', '--quiet', '--warnings-as-errors=*')
# Options of g++ only, and headers that only g++ reads.
FOREIGN = re.compile(
    r'-Winvalid-pch|-fpch-preprocess|-Werror|-m(move-max|store-max|memset-strategy|memcpy-strategy)=\S+'
    r'|-Wno-(maybe-uninitialized|restrict|psabi)'
)


def forClang(command):
    """The compile command without precompiled headers and options that clang does not support."""
    words, kept = shlex.split(command), []
    skip = False
    for word, after in zip(words, words[1:] + ['']):
        if skip:
            skip = False
        elif word == '-include' and 'cmake_pch' in after:
            skip = True
        elif not FOREIGN.fullmatch(word) and 'cmake_pch' not in word and not word.endswith('ccache'):
            kept.append(word)
    return shlex.join(kept)


def database(build):
    """Compile commands by path in the tree; the last one for files that are compiled several times."""
    with open(os.path.join(build, 'compile_commands.json'), encoding='utf-8') as stream:
        entries = json.load(stream)
    found = {}
    for entry in entries:
        path = os.path.relpath(os.path.join(entry['directory'], entry['file']), ROOT)
        if 'cmake_pch' not in path and not path.startswith(('..', 'build')):
            found[path] = {**entry, 'command': forClang(entry['command'])}
    return found


def changedFiles(commit):
    names = subprocess.run(
        ['git', 'diff', '--name-only', '--diff-filter=d', commit],
        cwd=ROOT,
        text=True,
        capture_output=True,
        check=True,
    ).stdout.split('\n')
    new = subprocess.run(
        ['git', 'ls-files', '--others', '--exclude-standard'],
        cwd=ROOT,
        text=True,
        capture_output=True,
        check=True,
    ).stdout.split('\n')
    return sorted({name for name in names + new if isCpp(name)})


def includersOf():
    """Files that include a header, by the header's path."""
    includers = {}
    for file in filter(isCpp, trackedFiles()):
        for line in readLines(file):
            if line.startswith('#include "'):
                includers.setdefault(line.split('"')[1], []).append(file)
    return includers


def sourcesOf(files, sources):
    """Sources that cover all files; a header has the source of its name, or the nearest that includes it."""
    seen, includers = {file for file in files if file in sources}, includersOf()
    for header in (file for file in files if file.endswith('.hpp')):
        near = [header[:-4] + '.cpp', header]
        for file in near:  # near grows in the loop
            if file in sources:
                seen.add(file)
                break
            near += [other for other in includers.get(file, []) if other not in near]
        else:
            print(f'clang-tidy: no source includes {header}, so it is not checked', file=sys.stderr)
    return sorted(seen)


def tidy(folder, source, *options):
    done = subprocess.run(
        [CLANG_TIDY, '-p', folder, *CONFIGURED, *options, str(ROOT / source)],
        capture_output=True,
        text=True,
    )
    return done.returncode, done.stdout + (done.stderr if done.returncode and not done.stdout else '')


def tidyGroup(folder, group):
    """Checks a source, or a source that includes all of several."""
    if len(group) == 1:
        return tidy(folder, group[0])
    code, text = tidy(folder, unityFile(folder, group), '--checks=-bugprone-suspicious-include')
    if 'clang-diagnostic' not in text:
        return code, text
    alone = [tidy(folder, source) for source in group]
    return max(code for code, _ in alone), '\n'.join(text.strip() for _, text in alone if text.strip())


def unityFile(folder, group):
    return os.path.join(folder, group[0].replace('/', '_'))


def groupsOf(sources, together):
    """Groups of sources: those of a folder with the same compile command, or each alone."""
    groups = {}
    for source, entry in sorted(sources.items()):
        options = [word for word in shlex.split(entry['command']) if not word.endswith(('.cpp', '.o'))]
        key = (os.path.dirname(source), *options) if together else source
        groups.setdefault(key, []).append(source)
    return [
        group[i : i + MOST_TOGETHER] for group in groups.values() for i in range(0, len(group), MOST_TOGETHER)
    ]


def writeDatabase(folder, sources, groups):
    """Writes the compile commands, and a source for each group of several."""
    entries = list(sources.values())
    for group in (group for group in groups if len(group) > 1):
        path, entry = unityFile(folder, group), sources[group[0]]
        with open(path, 'w', encoding='utf-8') as stream:
            stream.writelines(f'#include "{ROOT / source}"\n' for source in group)
        first = os.path.join(entry['directory'], entry['file'])
        entries.append({**entry, 'file': path, 'command': entry['command'].replace(first, path)})
    with open(os.path.join(folder, 'compile_commands.json'), 'w', encoding='utf-8') as stream:
        json.dump(entries, stream)


def main():
    build, since = sys.argv[1:3]
    sources = database(build)
    chosen = sorted(sources) if since == 'ALL' else sourcesOf(changedFiles(since), sources)
    if since != 'ALL' and len(chosen) > MOST_CHANGED:
        print(
            f'clang-tidy: {MOST_CHANGED} of {len(chosen)} changed sources; of all: scripts/lint --all',
            file=sys.stderr,
        )
        chosen = [chosen[i * len(chosen) // MOST_CHANGED] for i in range(MOST_CHANGED)]
    groups = groupsOf({source: sources[source] for source in chosen}, since == 'ALL')
    failed, shown = False, set()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        writeDatabase(folder, sources, groups)
        for code, text in pool.map(lambda group: tidyGroup(folder, group), groups):
            failed |= code != 0
            for finding in re.split(r'\n(?=\S+:\d+:\d+: (?:warning|error))', text.strip()):
                if finding and finding not in shown:  # several sources report the same finding of a header
                    shown.add(finding)
                    print(finding.replace(f'{ROOT}/', ''), flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
