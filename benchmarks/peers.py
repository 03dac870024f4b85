#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-only
"""Count the model evaluations that calibrators need on cheap stand-ins for a DEM.

The stand-ins are those of standIn.m ('plain': 5 parameters, 2 targets; 'rough': 6 parameters,
4 targets, interaction, plateau, kink). Every response carries independent multiplicative noise.
Compared are: evaluations at the tool's own stop, sets truly within 1 % of the noise-free model,
and the worst set. The first evaluation that happens to look right is luck; it is kept in the CSV.
This tool is run through octave-cli (peers.m), the others in this process.

Install: python3 -m venv v && v/bin/pip install grainlearning==2.0.5 coexist==0.3.2 cma optuna scikit-learn
Run:     v/bin/python benchmarks/peers.py --seeds 20 --ours 100
         v/bin/python benchmarks/peers.py --standin rough --fail 0.1 --peers yardstick,Optuna
         v/bin/python benchmarks/peers.py --verify-acces    (real coexist.Access against the copy here)
"""
import argparse
import contextlib
import csv
import io
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import textwrap
import time
import warnings
from multiprocessing import Pool

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
TOL = 0.01


class StandIn:
    """limits, names and formulas of standIn.m"""

    def __init__(self, name):
        self.name = name
        if name == "plain":
            self.names = ["rho", "mu_pp", "mu_pw", "mr_pp", "mr_pw"]
            self.lo = np.array([500., .3, .3, .025, .025])
            self.hi = np.array([800., .7, .7, .075, .075])
            self.target = np.array([400., .028])
        else:
            self.names = list("abcdef")
            self.lo, self.hi = np.zeros(6), np.ones(6)
            self.target = self.truth(np.array([.55, .5, .6, .4, .5, .5]))

    def truth(self, x):
        if self.name == "plain":
            rho, mpp, mpw, rpp, rpw = x
            return np.array([rho * (.62 - .06 * mpp - .25 * rpp),
                             .01 + .02 * mpp + .01 * mpw + .05 * rpp + .01 * rpw])
        a, b, c, d, e, f = x
        return np.array([18 + 14 * a * (.4 + .6 * b) + 4 * c,
                         60 + 40 * math.tanh(4 * (b - .45)) - 15 * d,
                         3 + 5 * max(0., c - .35) + 2 * a * e,
                         .02 * math.exp(1.5 * f) * (1 + .4 * d)])


class Budget(Exception):
    pass


class Dem:
    """counts every evaluation and remembers it; every (1/fail)-th one on average gives NaN"""

    def __init__(self, model, seed, noise, fail, cap):
        self.model, self.noise, self.fail, self.cap = model, noise, fail, cap
        self.rng, self.log = np.random.default_rng(10_000 + seed), []
        self.lo, self.hi, self.names = model.lo, model.hi, model.names
        self.d, self.T = len(model.lo), len(model.target)

    def __call__(self, x):
        if len(self.log) >= self.cap:
            raise Budget
        x = np.asarray(x, float)
        y = self.model.truth(x)
        z = y * (1 + self.noise * self.rng.standard_normal(self.T))
        if self.rng.random() < self.fail:
            z = np.full(self.T, np.nan)
        self.log.append((x.copy(), z, y))
        return z

    def resid(self, x):
        return self(x) / self.model.target - 1

    def first(self, which):
        for i, record in enumerate(self.log):
            if np.max(np.abs(record[which] / self.model.target - 1)) < TOL:
                return i + 1
        return None

    def best_observed(self):
        seen = [r for r in self.log if np.isfinite(r[1]).all()]
        return min(seen, key=lambda r: np.max(np.abs(r[1] / self.model.target - 1)))[0]


# ---------------------------------------------------------------- peers
def grainlearning(dem, seed):
    """iterative Bayesian filter; int(5 d log d) samples, 5 iterations as in its DEM tutorial
    (triaxial compression); all other settings are its defaults. At least 20 samples: 6 for two
    parameters leave its filter one, and it crashes"""
    from grainlearning import BayesianCalibration
    from grainlearning.dynamic_systems import DynamicSystem
    np.random.seed(seed)

    def simulate(c):
        c.system.set_sim_data(np.array([dem(p) for p in c.system.param_data])[:, :, None])

    system = dict(system_type=DynamicSystem, model_name="standin", param_names=dem.names,
                  param_min=dem.lo.tolist(), param_max=dem.hi.tolist(),
                  num_samples=max(20, int(5 * dem.d * math.log(dem.d))),
                  obs_data=dem.model.target[:, None].tolist(), ctrl_data=[0.0])
    c = BayesianCalibration.from_dict(dict(num_iter=5, callback=simulate, system=system, save_fig=-1,
                                           inference=dict(Bayes_filter={}, sampling={})))
    c.run()
    return np.asarray(c.system.estimated_params[-1])


def product(r):
    return float(np.prod(np.abs(r)))


def total(r):
    return float(np.sum(np.abs(r)))


def acces_core(dem, seed, combine, population=8, target=0.1):
    """the ask-tell loop of coexist.Access.learn 0.3.2 (population 8, target sigma 0.1, start at the
    mid-point, sigma 40 % of the range); --verify-acces checks it against the real package"""
    import cma
    scale = .4 * (dem.hi - dem.lo)
    rng = np.random.default_rng(seed)
    es = cma.CMAEvolutionStrategy(((dem.lo + dem.hi) / 2) / scale, 1.,
                                  dict(bounds=[dem.lo / scale, dem.hi / scale], popsize=population, verbose=-9,
                                       randn=lambda *a: rng.standard_normal(a)))
    while not es.stop():
        sets = es.ask()
        es.tell(sets, [combine(dem.resid(s * scale)) for s in np.asarray(sets)])
        if es.sigma < target or np.all(es.result.stds < target):
            break
    return es.result.xbest * scale


def acces_product(dem, seed):
    return acces_core(dem, seed, product)


def acces_sum(dem, seed):
    return acces_core(dem, seed, total)


def optuna_tpe(dem, seed):
    """Optuna's default sampler, 200 trials, sum of squared relative residuals"""
    import optuna
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=seed))

    def objective(trial):
        x = np.array([trial.suggest_float(n, l, h) for n, l, h in zip(dem.names, dem.lo, dem.hi)])
        return float(np.sum(dem.resid(x) ** 2))

    study.optimize(objective, n_trials=200)
    return np.array([study.best_params[n] for n in dem.names])


def yardstick(dem, seed, n0=21):
    """the scheme of the published tool without its Rayleigh term: maximin Latin hypercube of 21, one
    Gaussian process a target, bounded least squares from the mid-point, up to 19 more evaluations that
    each refit; stops when an evaluation looks right"""
    from scipy.optimize import least_squares
    from scipy.spatial.distance import pdist
    from scipy.stats import qmc
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import ConstantKernel as C, DotProduct, Matern, WhiteKernel
    rng = np.random.default_rng(seed)
    width = dem.hi - dem.lo
    plans = (qmc.LatinHypercube(dem.d, seed=rng).random(n0) for _ in range(500))
    U = max(plans, key=lambda u: pdist(u).min())
    R = np.array([dem.resid(dem.lo + u * width) for u in U])
    for _ in range(19):
        ok = np.isfinite(R).all(axis=1)
        models = []
        for k in range(dem.T):
            kernel = (C(1.) * DotProduct(1.) + C(1.) * Matern(np.ones(dem.d), (1e-1, 1e2), nu=2.5)
                      + WhiteKernel(1e-4, (1e-8, 1e0)))
            models.append(GaussianProcessRegressor(kernel, normalize_y=True, random_state=0).fit(U[ok], R[ok, k]))
        u = least_squares(lambda u: [m.predict(u[None])[0] for m in models], np.full(dem.d, .5),
                          bounds=(0, 1), diff_step=1e-3).x
        r = dem.resid(dem.lo + u * width)
        U, R = np.vstack([U, u]), np.vstack([R, r])
        if np.max(np.abs(r)) < TOL:
            return dem.lo + u * width
    return dem.best_observed()


PEERS = {
    "GrainLearning 2.0.5": grainlearning,
    "ACCES (coexist 0.3.2), product": acces_product,
    "ACCES (coexist 0.3.2), sum": acces_sum,
    "Optuna TPE, 200 trials": optuna_tpe,
    "yardstick: LHS 21 + GP + LM": yardstick,
}


def attempt(name, dem, seed):
    """the set that a peer hands back, and what ended it; a crash is a result, too"""
    try:
        return PEERS[name](dem, seed), ""
    except Budget:
        return dem.best_observed(), "cap"
    except Exception as e:
        return None, f"{type(e).__name__}: {e}"[:80]


def one(job):
    name, standin, seed, noise, fail, cap = job
    # GrainLearning wants all memory at some seeds; a killed worker would be waited for forever
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    model = StandIn(standin)
    dem = Dem(model, seed, noise, fail, cap)
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()), \
            warnings.catch_warnings():
        warnings.simplefilter("ignore")
        x, error = attempt(name, dem, seed)
    worst = math.nan if x is None else float(np.max(np.abs(model.truth(x) / model.target - 1)))
    return dict(tool=name, standin=standin, fail=fail, seed=seed, runs=len(dem.log), first_observed=dem.first(1),
                first_true=dem.first(2), worst=worst, error=error)


def ours(standin, fail, seeds):
    """this tool, its own program, its own generator of noise (same law)"""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "ours.csv")
        subprocess.run(["octave-cli", "--no-gui", "--no-history", os.path.join(HERE, "peers.m"), standin, str(fail),
                        f"1:{seeds}", out], check=True, stdout=subprocess.DEVNULL)
        with open(out, encoding="utf-8") as f:
            lines = [line for line in f if not line.startswith("#")]
        table = np.loadtxt(lines[1:], delimiter=",", ndmin=2)
    return [dict(tool="DEcalioc", standin=standin, fail=fail, seed=int(r[0]), runs=int(r[1]), first_observed=r[5],
                 first_true=r[6], worst=float(r[7]), error="") for r in table]


def origin_lines(hours=None):
    """what made a table: its first lines (originLines.m)"""
    words = [os.path.basename(w) if w.startswith("/") else w for w in sys.argv[1:]]
    call = " ".join(["python", "benchmarks/" + os.path.basename(sys.argv[0])] + words)
    git = ["git", "-C", HERE]
    commit = subprocess.run(git + ["rev-parse", "--short=8", "HEAD"], capture_output=True, text=True).stdout.strip()
    changed = subprocess.run(git + ["status", "--porcelain", "--", ".", "../infrastructure", ":!results"],
                             capture_output=True, text=True).stdout
    if commit and changed:
        commit += "+"
    if hours is None:
        used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        hours = f"{sum(u.ru_utime + u.ru_stime for u in used) / 3600:.3g}"
    return (f"# program: {call}\n# commit: {commit or 'not known'}\n# date: {time.strftime('%Y-%m-%d')}\n"
            f"# machine: {os.cpu_count()} cores, load {os.getloadavg()[0]:.0f}\n# core-hours: {hours}\n")


def report(rows):
    runs = [r["runs"] for r in rows]
    worst = [r["worst"] for r in rows if not math.isnan(r["worst"])]
    crashed = sum(1 for r in rows if r["error"] and r["error"] != "cap")
    good = sum(1 for w in worst if w < TOL)
    text = f"| {rows[0]['tool']} | {good}/{len(rows)} | {statistics.median(runs):g} ({max(runs)}) | "
    text += f"{100 * max(worst):.1f} % |" if worst else "- |"
    print(text + (f" crashed {crashed} of {len(rows)} |" if crashed else " |"), flush=True)


def verify_acces(seed=1, target=.4):
    """real coexist.Access in a temporary folder, no noise; stopped early (target sigma 0.4), because the
    package needs seconds for an evaluation"""
    model = StandIn("plain")
    script = textwrap.dedent(f'''
        # ACCESS PARAMETERS START
        import coexist
        parameters = coexist.create_parameters(variables={model.names}, minimums={model.lo.tolist()},
                                               maximums={model.hi.tolist()})
        # ACCESS PARAMETERS END
        rho, mpp, mpw, rpp, rpw = parameters["value"]
        d = rho * (.62 - .06 * mpp - .25 * rpp)
        m = .01 + .02 * mpp + .01 * mpw + .05 * rpp + .01 * rpw
        error = [abs(d / 400 - 1), abs(m / .028 - 1)]
        ''')
    for name, combine in (("Product", product), ("Sum", total)):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "sim.py"), "w", encoding="utf-8") as f:
                f.write(script)
            call = (f"import coexist; coexist.Access('sim.py').learn(random_seed={seed}, verbose=0, "
                    f"target_sigma={target}, multi_objective=coexist.combiners.{name}())")
            subprocess.run([sys.executable, "-c", call], cwd=folder, check=True, stdout=subprocess.DEVNULL)
            real = np.loadtxt(os.path.join(folder, f"access_seed{seed}", "history_pop8.csv"))
        dem = Dem(model, seed, 0., 0., 10**6)
        acces_core(dem, seed, combine, target=target)
        copy = np.array([r[0] for r in dem.log])
        same = len(copy) == len(real) and np.allclose(copy, real[:, :5], rtol=1e-9)
        print(f"ACCES {name}: real {len(real)} evaluations, copy {len(copy)}, identical: {same}")


def main():
    p = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    p.add_argument("--seeds", type=int, default=20, help="seeds of the peers")
    p.add_argument("--ours", type=int, default=100, help="seeds of this tool (0: leave it out)")
    p.add_argument("--standin", default="plain,rough")
    p.add_argument("--fail", default="0,0.1")
    p.add_argument("--noise", type=float, default=.01)
    p.add_argument("--cap", type=int, default=3000)
    p.add_argument("--peers", default="", help="parts of the names, separated by commas")
    p.add_argument("--jobs", type=int, default=1)
    p.add_argument("--csv", default=os.path.join(HERE, "results", "peers.csv"))
    p.add_argument("--verify-acces", action="store_true")
    a = p.parse_args()
    if a.verify_acces:
        verify_acces()
        return
    everything = []
    for standin in a.standin.split(","):
        for fail in map(float, a.fail.split(",")):
            print(f"\n{standin}, noise {100 * a.noise:g} %, {100 * fail:g} % of the runs fail\n\n"
                  "| tool | sets truly within 1 % | runs, median (max) | worst set | |\n|---|---|---|---|---|")
            for name in PEERS:
                if a.peers and not any(part in name for part in a.peers.split(",")):
                    continue
                started = time.time()
                jobs = [(name, standin, seed, a.noise, fail, a.cap) for seed in range(1, a.seeds + 1)]
                with Pool(a.jobs, maxtasksperchild=1) as pool:       # GrainLearning keeps what it took
                    rows = list(pool.imap(one, jobs))
                report(rows)
                print(f"{name}: {time.time() - started:.0f} s", file=sys.stderr)
                everything += rows
            if a.ours:
                rows = ours(standin, fail, a.ours)
                report(rows)
                everything += rows
    os.makedirs(os.path.dirname(os.path.abspath(a.csv)), exist_ok=True)
    with open(a.csv, "w", newline="", encoding="utf-8") as f:
        f.write(origin_lines())
        w = csv.DictWriter(f, fieldnames=list(everything[0]))
        w.writeheader()
        w.writerows(everything)


if __name__ == "__main__":
    main()
