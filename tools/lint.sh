#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Checks the style (miss_hit.cfg) of all Octave code, the shell code, spelling and
# phrases of the manual, which folder calls which (tools/graph), and whether the
# tables of the manual are those of benchmarks/results.
# CALL: tools/lint.sh          (or: make lint); exit status 1 for any finding
#       tools/lint.sh --fix    (or: make format); lays out the Octave code first
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=$(sed -n 's/^miss_hit==\([^ ]*\).*/\1/p' tools/requirements-lint.txt)
venv=${XDG_CACHE_HOME:-$HOME/.cache}/decalioc/miss_hit-$version

# The file `complete` is made last, so a broken installation is done again.
installTools () {
  local log=$venv.log
  mkdir -p "$(dirname "$venv")"
  exec 9> "$venv.lock"
  flock 9
  [ -e "$venv/complete" ] && return
  echo "Lint: installing miss_hit $version"
  rm -rf "$venv"
  { python3 -m venv "$venv" &&
      "$venv/bin/pip" install --require-hashes --only-binary :all: \
        --requirement tools/requirements-lint.txt; } > "$log" 2>&1 || {
    tail -n 10 "$log" >&2
    echo "lint.sh: miss_hit $version could not be installed from PyPI, see above." >&2
    exit 1
  }
  touch "$venv/complete"
}
[ -e "$venv/complete" ] || installTools

# What git knows or could learn: no copies of models in folders of runs.
list () { git ls-files -z --cached --others --exclude-standard -- "$@"; }
git rev-parse 2>/dev/null ||
  list () { find . -type f \( -name "$1" -o -name "${2:-$1}" \) -print0; }
mapfile -d '' octave < <(list '*.m' '*.tst')
mapfile -d '' shell < <(list '*.sh')

check () { "$venv/bin/$1" --input-encoding UTF-8 "${@:2}" "${octave[@]}"; }

if [ "${1:-}" = --fix ]; then
  check mh_style --fix > /dev/null || true
  check mh_style --fix > /dev/null || true    # some layouts need two goes
fi
findings=0
check mh_style || findings=1
check mh_lint || findings=1
# A metric of branches alone is a warning: to hide them in arithmetic would be worse.
metrics=$(check mh_metric --ci 2>&1) || {
  found=$(grep '\^ ' <<< "$metrics")
  { [ -n "$found" ] && ! grep -qv '\[cyc\]$' <<< "$found"; } || findings=1
}
echo "$metrics"
# camelCase names are words to it: those that it takes for mistakes
git ls-files -z '*.m' '*.tst' '*.sh' '*.md' '*.txt' '*.head' '*.yml' 2> /dev/null |
  xargs -0 --no-run-if-empty codespell -L acces,upto,fro,atleast,testof,nnumber,loadin || findings=1
shellcheck -x --severity=warning .ci/run "${shell[@]}" || findings=1
"$venv/bin/python3" tools/assertTexts.py "${octave[@]}" || findings=1
"$venv/bin/python3" tools/phrases.py || findings=1
# What is small depends on the unit: eps (x) is relative, eps alone is not.
noEps=(infrastructure/{diagnosis,surrogates,calibration})
if grep -rnwE --include='*.m' 'eps' "${noEps[@]}" |
    grep -vE ':[0-9]+:%|eps \('; then
  echo 'Absolute eps where values have units: write eps (x), or a share of x' >&2
  findings=1
fi
# Octave 9 stops where an argument is a field of what a map holds.
if grep -rnE --include='*.m' "\\b\w+\('\w+'\)\.\w+" infrastructure | grep -vE ':[0-9]+: *%'; then
  echo 'A field of what a map holds: take it out of the map first' >&2
  findings=1
fi
# Of two functions with one name, one hides the other.
twice=$(printf '%s\n' "${octave[@]}" | grep -E '^(infrastructure|benchmarks|tests)/.*\.m$' |
  grep -v '/\(DEMmodels\|loadInput\|loadEffects\|OctaveFuns\)' | sed 's|.*/||' | sort | uniq -d)
[ -z "$twice" ] || {
  echo "Two functions have one name: $twice" >&2
  findings=1
}
# The tasks of CONTRIBUTING.md; tests/patches.tst runs their tests, when there is time.
for task in tests/patches/*.patch; do
  git apply --check "$task" || findings=1
done
# The version that is cited is that of the package.
grep -qx "version: $(< VERSION)" CITATION.cff || {
  echo 'CITATION.cff must have the version of the file VERSION (tools/release.sh)' >&2
  findings=1
}
tools/spdx.sh || findings=1
tools/graph/graph.sh || findings=1
# Tables of the manual are those of their results; which results are old, it says.
"${OCTAVE:-octave-cli}" --no-gui --norc --quiet benchmarks/figures.m check 2>&1 |
  { grep -v 'ignoring const execution_exception' || true; } || findings=1
exit $findings
