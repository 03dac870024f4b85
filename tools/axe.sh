#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Installs axe-core, the checker of accessible pages that tests/page.tst uses,
# for this user and prints the path of its script. Nothing where it cannot.
# CALL: tools/axe.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# of the Python package that carries axe.min.js
version=$(sed -n 's/^axe-playwright-python==\([^ ]*\).*/\1/p' "$here/requirements-axe.txt")
place=${XDG_CACHE_HOME:-$HOME/.cache}/decalioc/axe-$version

# The file `complete` is made last, so a broken installation is done again.
if [ ! -e "$place/complete" ]; then
  rm -rf "$place"
  mkdir -p "$place"
  { python3 -m venv "$place/venv" &&
      "$place/venv/bin/pip" install --no-deps --require-hashes --only-binary :all: \
        --requirement "$here/requirements-axe.txt" &&
      cp "$place"/venv/lib/python3*/site-packages/axe_playwright_python/axe.min.js "$place" &&
      rm -rf "$place/venv" && touch "$place/complete"; } > "$place.log" 2>&1 || {
    tail -n 5 "$place.log" >&2
    echo "axe.sh: axe-core could not be installed from PyPI; the page is tested without it." >&2
    exit
  }
fi
echo "$place/axe.min.js"
