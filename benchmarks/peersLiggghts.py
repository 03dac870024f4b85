#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-only
"""Peers on a real LIGGGHTS model: runs and core-seconds to a set that is right.

The model is the template Repose (decalioc new --model Repose): two parameters, angle of repose
to 6 % and mass on the plate to 4 %, some 10 s a run. Each tool is that of peers.py, with its
own defaults and its own stop; results are stretched about their targets so that the 1 % of
these tools is the tolerance. Whether the set handed back is right, say the surrogates of 121
other runs (results/reposeRuns.csv), as in reposeSeeds.m, which is this tool's side.

Install: see peers.py, and make liggghts
Run:     v/bin/python benchmarks/peersLiggghts.py WORK CSV --seeds 1:3 --peers GrainLearning,yardstick
"""
import argparse
import csv
import os
import subprocess
import time

import numpy as np

import peers

ROOT = os.path.dirname(peers.HERE)
TARGET = np.array([30.5, 0.0120])
TOL = np.array([0.06, 0.04])


def octave(code, folder=ROOT):
    """prints of CODE, in an Octave with the toolbox and this case folder"""
    start = (f"addpath ('{ROOT}/infrastructure'); startToolbox ('{ROOT}', pwd ()); addpath ('{ROOT}/benchmarks'); "
             f"useLiggghts ('{ROOT}');")
    call = ["octave-cli", "--no-gui", "--no-history", "--norc", "--eval", start + code]
    done = subprocess.run(call, capture_output=True, text=True, check=True, cwd=folder)
    return [float(x) for x in done.stdout.split("RESULT")[1].split()]


class Box:
    """parameters of the model and their limits"""

    names = ["coefFrictionPP", "coefRollingFrictionPP"]
    lo, hi = np.array([0.2, 0.02]), np.array([0.8, 0.30])
    target = TARGET


class Rig(peers.Dem):
    """one calibration's model: each call is a LIGGGHTS run with a packing of its own"""

    def __init__(self, folder, cap):
        super().__init__(Box, 0, 0, 0, cap)
        self.folder, self.seconds = folder, 0.0
        if not os.path.isdir(folder):
            subprocess.run([os.path.join(ROOT, "bin", "decalioc"), "new", "--model", "Repose", folder],
                           check=True, stdout=subprocess.DEVNULL)

    def __call__(self, x):
        if len(self.log) >= self.cap:
            raise peers.Budget
        x = np.clip(np.asarray(x, float), self.lo, self.hi)
        k = len(self.log) + 1
        *z, seconds = octave(
            f"Case = loadCase ('{ROOT}', '{self.folder}'); [Z, r] = evaluateDEM ([{x[0]:.17g}, {x[1]:.17g}], "
            f"Case, {k}, 'peer', newProgress ('', @(t) [])); printf ('RESULT %.17g %.17g %g', Z(1:2), r.seconds)", self.folder)
        self.seconds += seconds
        z = TARGET * (1 + (np.array(z) / TARGET - 1) * peers.TOL / TOL)
        self.log.append((x.copy(), z, z))
        return z


def judge(x):
    """how far off the set truly is, in tolerances"""
    return max(octave(
        f"s = storedRepose ('{ROOT}'); p = s.problem; t = fitSurrogates (s.data, p); "
        f"z = predictSurrogate (t, [{x[0]:.17g}, {x[1]:.17g}]); c = p.calibrate; "
        "printf ('RESULT %g %g', abs (z(c) ./ p.value(c) - 1) ./ p.tol(c))"))


def main():
    p = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    p.add_argument("work")
    p.add_argument("csv")
    p.add_argument("--seeds", default="1:3")
    p.add_argument("--peers", default="", help="parts of the names, separated by commas")
    p.add_argument("--cap", type=int, default=600)
    a = p.parse_args()
    first, last = map(int, a.seeds.split(":"))
    os.makedirs(a.work, exist_ok=True)
    for name in peers.PEERS:
        if a.peers and not any(part in name for part in a.peers.split(",")):
            continue
        for seed in range(first, last + 1):
            place = os.path.join(os.path.abspath(a.work), f"{name.split()[0].strip(':')}{name.count('sum')}-{seed}")
            rig = Rig(place, a.cap)
            started = time.time()
            x, error = peers.attempt(name, rig, seed)
            worst = judge(x) if x is not None else float("nan")
            isnew = not os.path.exists(a.csv)
            with open(a.csv, "a", newline="", encoding="utf-8") as f:
                w = csv.writer(f)
                if isnew:
                    f.write(peers.origin_lines("seconds of the rows"))
                    w.writerow("tool seed runs seconds worst wall error".split())
                w.writerow([name, seed, len(rig.log), f"{rig.seconds:.0f}", f"{worst:.3f}",
                            f"{time.time() - started:.0f}", error])


if __name__ == "__main__":
    main()
