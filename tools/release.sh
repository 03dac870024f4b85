#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Makes a release: version in VERSION, CITATION.cff and docs/install.md, heading of
# CHANGELOG.md, the package (dist.sh) and the manual (site/build.sh). Refuses a tree
# with changes that are not committed, and a version that is not above the last. What
# it has changed is for you to look at and to commit: it says how.
# CALL: tools/release.sh VERSION [without-site]      (or: make release NUMBER=VERSION)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

refuse () { echo "release.sh: $1" >&2; exit 1; }

new=${1:-}
old=$(< VERSION)
[[ $new =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] ||
  refuse "VERSION must be three numbers such as 1.0.0, got '$new'."
[ "$new" != "$old" ] && [ "$(printf '%s\n' "$old" "$new" | sort -V | tail -n 1)" = "$new" ] ||
  refuse "VERSION must be above $old, got $new."
[ -z "$(git status --porcelain)" ] ||
  refuse "the tree must be as it was committed, got: $(git status --short | head -n 3 | tr '\n' ';')"
grep -q "^## After $old$" CHANGELOG.md ||
  refuse "CHANGELOG.md must have a heading '## After $old' with what is new, got none."

day=$(date +%F)
echo "$new" > VERSION
sed -i "s/^## After ${old//./\\.}$/## $new ($day)/" CHANGELOG.md
sed -i -e "s/^version: .*/version: $new/" -e "s/^date-released: .*/date-released: $day/" CITATION.cff
sed -i "s/decalioc-${old//./\\.}\.tar/decalioc-$new.tar/" docs/install.md
tools/dist.sh
[ "${2:-}" = without-site ] || tools/site/build.sh
cat << END
Look at it (git diff), then:
  git commit --all --message 'Version $new' && git tag --annotate v$new --message 'Version $new'
and hand over dist/. The next change begins '## After $new' in CHANGELOG.md.
END
