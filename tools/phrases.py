# SPDX-License-Identifier: GPL-3.0-only
"""Finds phrases that the manual does without: tools/phrases.txt lists them.

CALL: tools/phrases.py           exit status 1 for any finding
      tools/phrases.py PAGE...   other pages, as of the user guide

Read are README.md, CONTRIBUTING.md, docs/*.md and the sentences of words.txt, a
paragraph at a time, so that a line break hides nothing. What programs print or
read (code, names of files) and the addresses of links are left aside.
"""
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SENTENCES = ROOT / 'infrastructure/report/words/words.txt'
MADE = ROOT / 'docs/functions.md'          # of help texts, by `make index`


def phrases(file):
    """(where, pattern, what to say) of each line."""
    for line in file.read_text().splitlines():
        if line and not line.startswith('#'):
            where, phrase, better = line.split('\t')
            yield where, re.compile(rf'(?<!\w)(?:{phrase.strip()})(?!\w)', re.I), better


def blank(match):
    """As long and with as many lines, without words."""
    return re.sub(r'[^\n]', '_', match.group())


def words_of(text):
    text = re.sub(r'^ *```.*?^ *```', blank, text, flags=re.M | re.S)
    text = re.sub(r'`[^`]*`', blank, text)
    return re.sub(r'(?<=\])\([^)\s]*\)', blank, text)


def findings(text, rules):
    """(line, phrase, what to say) wherever a rule is broken."""
    text = words_of(text)
    flat = re.sub(r'(?<!\n)\n *(?![\n|*#-])', lambda m: ' ' * len(m.group()), text)
    for pattern, better in rules:
        spaced = re.compile(pattern.pattern.replace(' ', ' +'), re.I)
        for match in spaced.finditer(flat):
            line = text.count('\n', 0, match.start()) + 1
            yield line, ' '.join(match.group().split()), better


def guide():
    """Pages of the user guide, as docs/README.md lists them."""
    text = (ROOT / 'docs/README.md').read_text()
    part = text.split('## User guide')[1].split('\n## ')[0]
    return [ROOT / 'README.md', ROOT / 'docs/README.md', SENTENCES] + \
           [ROOT / 'docs' / name for name in re.findall(r'\(([a-z-]+\.md)\)', part)]


def main():
    rules = list(phrases(ROOT / 'tools/phrases.txt'))
    given = [pathlib.Path(page).resolve() for page in sys.argv[1:]]
    inGuide = given or guide()
    pages = given or [ROOT / 'README.md', ROOT / 'CONTRIBUTING.md', SENTENCES,
                      *sorted((ROOT / 'docs').glob('*.md'))]
    bad = False
    for page in pages:
        if page == MADE:
            continue
        own = [(p, b) for where, p, b in rules if where == 'all' or page in inGuide]
        text = page.read_text()
        if page == SENTENCES:        # its remarks and codes are for programmers
            text = re.sub(r'^(#.*|[a-z][\w.-]*(/changed)?:)', blank, text, flags=re.M)
        for line, phrase, better in sorted(findings(text, own)):
            print(f'{os.path.relpath(page, ROOT)}:{line}: "{phrase}": {better}')
            bad = True
    sys.exit(bad)


if __name__ == '__main__':
    main()
