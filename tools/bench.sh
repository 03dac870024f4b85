#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Lists the programs of benchmarks/ with the first line of their help texts.
# Those in a folder below are functions: see benchmarks/startBenchmarks.m.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for file in benchmarks/*.m benchmarks/*/*.m; do
  printf '%-44s %s\n' "$file" "$(sed -nE '/^#!/d; s/^[%#]+ *//p; T; q' "$file")"
done
