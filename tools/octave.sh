#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Runs a script of the toolbox in Octave, in the folder CASE, with the right
# LIGGGHTS first in PATH. The exit status is Octave's.
# CALL: tools/octave.sh SCRIPT [ARGUMENT...]   (SCRIPT: below the toolbox folder)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

folder=$("$root/tools/liggghts/path.sh")
export PATH="$folder:$PATH"

# Runs on one machine need no search for networks: a start takes 0.03 s, not 0.3 s.
export OMPI_MCA_ess_singleton_isolated=${OMPI_MCA_ess_singleton_isolated-1}
export OMPI_MCA_pml=${OMPI_MCA_pml-ob1}
export OMPI_MCA_btl=${OMPI_MCA_btl-self,vader}
# As in bin/decalioc: small matrices gain nothing by threads.
export OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS-1}

cd "${CASE:-$root}" || {
  echo "octave.sh: there is no folder CASE=$CASE." >&2
  exit 1
}
# --norc: a start-up file of the user's must not change a calibration
exec "${OCTAVE:-octave-cli}" --no-gui --no-history --norc "$root/$1" "${@:2}"
