# SPDX-License-Identifier: GPL-3.0-only
"""Finds assert (x, y, text): Octave takes the third argument for a tolerance.

A text as tolerance makes nearly every comparison of numbers pass. Prints
the file and the text; the exit status is 1 for any finding.
CALL: assertTexts.py FILE...
"""
import re
import sys

# A text: a literal, what is in a cell, a field, or a name that is no tolerance.
TEXT = re.compile(r"""['"]|^\w+\{|^\[\s*[A-Za-z]|^(?!eps$|tol)[A-Za-z]\w*(\.\w+)*$""")
FORMAT = re.compile(r"""^['"].*%""")
WORD = re.compile(r'''(?<![\w)\]}'.])'(?:[^'\n]|'')*'|"(?:[^"\\\n]|\\.)*"|.''', re.S)


def arguments(text, start):
    """The arguments of the call whose bracket opens before START."""
    found, depth = [''], 1
    for word in WORD.finditer(text, start):
        word = word.group()
        depth += (word in tuple('([{')) - (word in tuple(')]}'))
        if depth == 0:
            return [part.strip() for part in found]
        if word == ',' and depth == 1:
            found.append('')
        else:
            found[-1] += word
    return []


def main(files):
    findings = 0
    for file in files:
        with open(file, encoding='utf-8', errors='replace') as source:
            text = source.read()
        text = re.sub(r'\.\.\.[^\n]*\n(?:%!)?', ' ', text)
        text = re.sub(r'^% .*', '', text, flags=re.M)
        for call in re.finditer(r'\bassert \(', text):
            given = arguments(text, call.end())
            if len(given) == 3 and TEXT.search(given[2]) and not FORMAT.match(given[1]):
                print(f'{file}: assert (..., {given[2]}) takes a text for a tolerance: '
                      'write assert (x == y, text)')
                findings += 1
    return int(findings > 0)


sys.exit(main(sys.argv[1:]))
