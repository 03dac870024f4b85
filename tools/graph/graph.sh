#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Prints the calls between the folders of the toolbox, and the doors of each; exit
# status 1 where a call goes up, two subfolders call each other, a function has no
# caller, or the map (infrastructure/README.md) is old.
# CALL: tools/graph/graph.sh          (or: make graph)
#       tools/graph/graph.sh --doors  the doors alone (or: make doors)
#       tools/graph/graph.sh --map    writes the map (or: make map)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
code="exit (showGraph (pwd ()) || showDoors (pwd (), true))"
case ${1:-} in
  --doors) code="exit (showDoors (pwd (), true))" ;;
  --map)   code="exit (showDoors (pwd ()))" ;;
esac
exec "${OCTAVE:-octave-cli}" --no-gui --norc --quiet \
  --eval "addpath ('tools/graph', 'infrastructure/kit/files'); $code" 2>&1 |
  { grep -v 'ignoring const execution_exception' || true; }
