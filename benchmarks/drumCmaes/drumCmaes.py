#!/usr/bin/env python3
"""Calibrate the drum of examples/granudrum with CMA-ES, as ACCES does.

CALL: drumCmaes.py WORK [GENERATIONS] [SEED] [CSVFILE]

WORK         folder for the case and its runs; what is there is not run again
GENERATIONS  of 8 sets each (4: 32 runs of two speeds, 64 as ACCES counts them)
SEED         of the sampling (1)
CSVFILE      one row a set: generation, sliding, rolling, solid share, rms at 15
             and at 45 rpm (mm)

The settings are those of coexist.Access 0.3.2 (see acces_core in peers.py): population 8, start in the
middle of the box, sigma 40 % of the range. The cost is the sum of both mean square deviations, which
is what the fit of DEcalioc.m minimises but for the correlation along the curves; ACCES itself compares
pictures. A failed run costs a deviation of 20 mm.

Install: python3 -m venv v && v/bin/pip install cma
"""
import csv
import os
import subprocess
import sys

import cma
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
LOW = np.array([0.2, 0.02, 0.21])
HIGH = np.array([1.0, 0.90, 0.29])
HEAD = ["generation", "sliding", "rolling", "solidShare", "rms15", "rms45"]


def run_sets(work, sets):
    given = os.path.join(work, "sets.csv")
    out = os.path.join(work, "rms.csv")
    np.savetxt(given, sets, delimiter=",", fmt="%.10g")
    subprocess.run(["octave-cli", os.path.join(HERE, "drumSets.m"), work, given, out], check=True)
    return np.atleast_2d(np.genfromtxt(out, delimiter=","))[:, 3:]


def main():
    given = sys.argv[1:] + ["", "", ""]
    work = os.path.abspath(given[0])
    generations = int(given[1] or 4)
    rng = np.random.default_rng(int(given[2] or 1))
    os.makedirs(work, exist_ok=True)
    scale = .4 * (HIGH - LOW)
    es = cma.CMAEvolutionStrategy((LOW + HIGH) / 2 / scale, 1.,
                                  dict(bounds=[LOW / scale, HIGH / scale], popsize=8, verbose=-9,
                                       randn=lambda *a: rng.standard_normal(a)))
    table = []
    for generation in range(1, generations + 1):
        asked = es.ask()
        rms = run_sets(work, np.asarray(asked) * scale)
        cost = np.where(np.isfinite(rms), rms, 20.)
        es.tell(asked, list(np.sum(cost ** 2, axis=1)))
        table += [[generation, *(s * scale), *r] for s, r in zip(asked, rms)]
        best = min(table, key=lambda row: np.nansum(np.square(row[4:])) if np.isfinite(row[4]) else np.inf)
        print(f"{8 * generation} runs, best so far: rms {best[4]:.2f} and {best[5]:.2f} mm at "
              f"{best[1]:.3f}, {best[2]:.3f}, {best[3]:.3f}", flush=True)
        if given[3]:
            with open(given[3], "w", newline="") as f:
                csv.writer(f).writerows([HEAD] + [[f"{v:.6g}" for v in row] for row in table])


if __name__ == "__main__":
    main()
