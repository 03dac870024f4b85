#!/bin/bash
# Checks the style (miss_hit.cfg) of all Octave code, and the shell code.
# CALL: tools/lint.sh      (or: make lint); exit status 1 for any finding
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=0.9.44
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
  { python3 -m venv "$venv" && "$venv/bin/pip" install "miss_hit==$version"; } > "$log" 2>&1 || {
    tail -n 10 "$log" >&2
    echo "lint.sh: miss_hit $version could not be installed from PyPI, see above." >&2
    exit 1
  }
  touch "$venv/complete"
}
[ -e "$venv/complete" ] || installTools

findings=0
"$venv/bin/mh_style" --input-encoding UTF-8 . || findings=1
"$venv/bin/mh_lint" --input-encoding UTF-8 . || findings=1
"$venv/bin/mh_metric" --input-encoding UTF-8 --ci . || findings=1
find tools .ci tests benchmarks DEMmodels examples -name '*.sh' -print0 2>/dev/null |
  xargs -0 shellcheck -x .ci/run || findings=1
exit $findings
