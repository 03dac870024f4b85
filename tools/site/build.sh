#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Builds the manual as a site with search, and as one PDF: dist/site/,
# dist/decalioc-manual.pdf.
# CALL: tools/site/build.sh      (or: make site)
# mkdocs comes from PyPI, pinned by hash, into an environment of its own; the
# PDF is printed by chromium, where that is there.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
key=$(sha256sum tools/site/requirements.txt | cut -c1-12)
venv=${XDG_CACHE_HOME:-$HOME/.cache}/decalioc/site-$key

# The file `complete` is made last, so a broken installation is done again.
installTools () {
  mkdir -p "$(dirname "$venv")"
  exec 9> "$venv.lock"
  flock 9
  [ -e "$venv/complete" ] && return
  echo "Site: installing mkdocs"
  rm -rf "$venv"
  { python3 -m venv "$venv" &&
      "$venv/bin/pip" install --require-hashes --only-binary :all: \
        --requirement tools/site/requirements.txt; } > "$venv.log" 2>&1 || {
    tail -n 10 "$venv.log" >&2
    echo "build.sh: mkdocs could not be installed from PyPI, see above." >&2
    exit 1
  }
  touch "$venv/complete"
}
[ -e "$venv/complete" ] || installTools

# The pages as they lie in the repository, so that every link between them holds.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/pages" dist
list () { git ls-files -z -- "$@"; }
git rev-parse 2> /dev/null ||
  list () { find . -path ./dist -prune -o -type f \( -name '*.md' -o -name '*.png' -o -name '*.jpg' -o -name '*.svg' -o -name LICENSE \) -print0; }
list '*.md' '*.png' '*.jpg' '*.svg' LICENSE |
  tar --create --dereference --null --files-from=- | tar --extract --directory="$work/pages"
# the badge of the tests is one of the place that hosts the repository
sed -i '1s/ <a href.*//' "$work/pages/README.md"
cp tools/site/mkdocs.yml "$work/mkdocs.yml"
( cd "$work" && "$venv/bin/mkdocs" build --quiet --site-dir "$root/dist/site.part" )
rm -rf dist/site
mv dist/site.part dist/site
echo "dist/site/index.html"

"$venv/bin/python3" tools/site/onePage.py "$work/mkdocs.yml" "$work/pages" \
  > "$work/pages/manual.html"
browser=$(command -v chromium || command -v chromium-browser || true)
if [ -z "$browser" ]; then
  echo "build.sh: there is no chromium, so no PDF is made. On Debian: apt-get install chromium" >&2
  exit
fi
"$browser" --headless --no-sandbox --disable-gpu --no-pdf-header-footer \
  --print-to-pdf="$root/dist/decalioc-manual.pdf" "file://$work/pages/manual.html" \
  > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
echo "dist/decalioc-manual.pdf"
