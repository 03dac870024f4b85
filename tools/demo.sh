#!/bin/bash
# A calibration that misses its measurements, and the diagnosis of why: the
# stored runs of examples/hiddenEffect, without LIGGGHTS, in a minute or two.
# CALL: tools/demo.sh [FOLDER [CHANGE]]   (default: decalioc-demo; must not exist
# yet); with CHANGE the case of examples/whatChanged, before and after
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-decalioc-demo}
mkdir -- "$folder" || {
  echo "demo.sh: a folder that does not exist yet is needed, got $folder. Name another one." >&2
  exit 1
}
cp "$root"/examples/hiddenEffect/load*.m "$folder"
cp "$root/examples/hiddenEffect/storedRuns.csv" "$folder/runs.csv"
if [ -n "${2:-}" ]; then
  cp "$root"/examples/whatChanged/{loadInput.m,measured.csv} "$folder"
  sed -i '1s/collapseSlope/Collapse_slope/; 1s/heapSlope/Heap_slope/; 1s/heapHeight/height/' \
    "$folder/runs.csv"
fi
sed -i 's/\(Input.maxNewRuns = \)[^;]*;.*/\10;                 % runs.csv alone/' "$folder/loadInput.m"

"$root/bin/decalioc" run "$folder" || [ $? -eq 2 ]      # 2: targets not met
"$root/bin/decalioc" diagnose "$folder"
