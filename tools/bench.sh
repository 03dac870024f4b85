#!/bin/bash
# Lists the programs of benchmarks/ with the first line of their help texts.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for file in benchmarks/*.m benchmarks/*.sh; do
  [ -f "$file" ] || continue
  printf '%-36s %s\n' "$file" "$(sed -nE '/^#!/d; s/^[%#]+ *//p; T; q' "$file")"
done
