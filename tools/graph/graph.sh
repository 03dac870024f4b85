#!/bin/bash
# Prints the calls between the folders of the toolbox; exit status 1 where one
# goes up, two subfolders call each other, or a function has no caller.
# CALL: tools/graph/graph.sh     (or: make graph)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
exec "${OCTAVE:-octave-cli}" --no-gui --norc --quiet \
  --eval "addpath ('tools/graph'); exit (showGraph (pwd ()))" 2>&1 |
  { grep -v 'ignoring const execution_exception' || true; }
