#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# A calibration that misses its measurements, and the diagnosis of why: the
# stored runs of examples/hiddenEffect, without LIGGGHTS, in a minute or two.
# CALL: tools/demo.sh [FOLDER [CHANGE]]   (default: decalioc-demo; where it is
# there already, decalioc-demo-2 and so on); with CHANGE the case of
# examples/whatChanged, before and after
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
wanted=${1:-decalioc-demo}
folder=$wanted
for ((n = 2; ; n++)); do
  [ -e "$folder" ] || break
  folder=$wanted-$n
done
mkdir -- "$folder" || {
  echo "demo.sh: a folder must be made here, got no $folder. Name another place." >&2
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

echo "This is a demonstration in $folder. Its measurements were simulated with LIGGGHTS, so that"
echo "the truth is known, and no simulation is made now: 153 stored runs are read."
if [ -n "${2:-}" ]; then
  echo "Planted: cohesion of 15 kJ/m3 in 'moist', 40 kJ/m3 in 'wet'. The model knows no cohesion."
else
  echo "Planted: cohesion of 50 kJ/m3. The model that is calibrated knows no cohesion, so it misses."
fi
"$root/bin/decalioc" run "$folder" || [ $? -eq 2 ]      # 2: targets not met
"$root/bin/decalioc" diagnose "$folder"
