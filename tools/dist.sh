#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Makes the Octave package: dist/decalioc-VERSION.tar.gz, of the files that git
# knows. Installed with: octave-cli --eval "pkg install dist/decalioc-..."
# CALL: tools/dist.sh      (or: make dist)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=$(< VERSION)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
package=$work/decalioc-$version
mkdir -p "$package/inst"

# What a user needs; links are followed, so that the models are whole.
parts=(DEcalioc.m diagnoseGap.m costFunction.m loadInput.m loadEffects.m VERSION LICENSE
       README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff Makefile bin share docs
       infrastructure DEMmodels examples templates tools)
list () { git ls-files -z -- "${parts[@]}"; }
git rev-parse 2> /dev/null || list () { find "${parts[@]}" \( -type f -o -type l \) -print0; }
list | tar --create --dereference --null --files-from=- | tar --extract --directory="$package/inst"

# The day of the release that CHANGELOG.md names, so that two calls make the
# same file.
date=$(sed -nE "s/^## ${version//./\\.} \(([0-9-]+)\)$/\1/p" CHANGELOG.md)
[ -n "$date" ] || {
  echo "dist.sh: CHANGELOG.md must have a heading '## $version (YYYY-MM-DD)', got none." >&2
  exit 1
}
sed -e "s/@VERSION@/$version/" -e "s/@DATE@/$date/" tools/dist/DESCRIPTION > "$package/DESCRIPTION"
cp tools/dist/INDEX "$package/INDEX"
cp CHANGELOG.md "$package/NEWS"
cp LICENSE "$package/COPYING"
mkdir -p dist
tar --create --gzip --file="dist/decalioc-$version.tar.gz.part" --directory="$work" \
    --sort=name --mtime="$date" --owner=0 --group=0 "decalioc-$version"
mv "dist/decalioc-$version.tar.gz.part" "dist/decalioc-$version.tar.gz"
echo "dist/decalioc-$version.tar.gz"
