# SPDX-License-Identifier: GPL-3.0-only
"""All pages of the manual as one HTML page, for printing.

CALL: onePage.py MKDOCS_YML PAGES > FILE

The pages come in the order of nav. A link from page to page becomes one inside
the document: #page--heading.
"""
import posixpath
import re
import sys

import markdown
import yaml

STYLE = """body { font: 10.5pt/1.45 serif; max-width: 42em; margin: auto }
h1 { break-before: page } pre, code { font-size: 85% }
pre { background: #f4f4f4; padding: .5em; white-space: pre-wrap }
table { border-collapse: collapse; font-size: 85% }
td, th { border: 1px solid #bbb; padding: .2em .4em; text-align: left }
img { max-width: 100% }"""


def pages_of(nav):
    """Paths of the pages, in order."""
    for entry in nav:
        for value in entry.values():
            if isinstance(value, str):
                yield value
            else:
                yield from pages_of(value)


def anchor(page, heading=''):
    return re.sub(r'[^\w-]', '_', page) + ('--' + heading if heading else '')


def with_links(html, page, known):
    """Anchors of this page get its name, links to other pages theirs."""
    def link(match):
        kind, target = match.groups()
        if re.match(r'[a-z]+:', target):
            return match.group(0)
        path, _, heading = target.partition('#')
        full = posixpath.normpath(posixpath.join(posixpath.dirname(page), path))
        full = full if path else page
        if kind == 'src':
            return 'src="%s"' % full
        return 'href="#%s"' % anchor(full, heading) if full in known else 'href="%s"' % target
    html = re.sub(r'\bid="([^"]*)"', lambda m: 'id="%s"' % anchor(page, m.group(1)), html)
    return re.sub(r'\b(href|src)="([^"]*)"', link, html)


def main(config, folder):
    with open(config, encoding='utf-8') as file:
        pages = list(pages_of(yaml.safe_load(file)['nav']))
    print('<!DOCTYPE html><meta charset="utf-8"><title>DEcalioc</title>')
    print('<style>%s</style>' % STYLE)
    for page in pages:
        with open(posixpath.join(folder, page), encoding='utf-8') as file:
            html = markdown.markdown(file.read(), extensions=['tables', 'fenced_code', 'toc'])
        print('<section id="%s">%s</section>' % (anchor(page), with_links(html, page, pages)))


main(*sys.argv[1:])
