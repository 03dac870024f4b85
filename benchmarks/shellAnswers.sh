#!/bin/bash
# shellAnswers.sh [TIMES]: how long the command decalioc takes for what the shell
# answers, and for what Octave answers, in milliseconds: median, least and most of
# TIMES calls (20) each, wall clock. The last but one line is Octave that starts
# and does nothing: what a call answered by the shell is spared.
#
# Writes a line "CALL,MEDIAN,LEAST,MOST" for each; reads and writes nothing else.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
times=${1:-20}
decalioc=$root/bin/decalioc

measure () {                  # measure LABEL COMMAND...
  local label=$1 start end
  shift
  for ((i = 0; i < times; i++)); do
    start=${EPOCHREALTIME/./}
    "$@" > /dev/null 2>&1 || true     # a refusal is an answer, too
    end=${EPOCHREALTIME/./}
    echo $((end - start))
  done | sort -n | awk -v label="$label" '
    { t[NR] = $1 / 1000 }
    END { middle = (t[int ((NR + 1) / 2)] + t[int (NR / 2) + 1]) / 2
          printf "%s,%.1f,%.1f,%.1f\n", label, middle, t[1], t[NR] }'
}

echo call,median_ms,least_ms,most_ms
measure '--help' "$decalioc" --help
measure '--version' "$decalioc" --version
measure 'check --help' "$decalioc" check --help
measure 'stauts (did you mean)' "$decalioc" stauts
measure 'Octave, empty' "${OCTAVE:-octave-cli}" --no-gui --no-history --norc --eval ''
measure 'benches (Octave answers)' "$decalioc" benches
