% MAKEHYPOTHESES  Prepares all hypotheses of a diagnosis for fast evaluation.
%
% CALL: HYPOTHESES = makeHypotheses (PROBLEM, EMULATOR, OPTIONS, TARGETS)
%
%   PROBLEM     struct of newProblem
%   EMULATOR    struct of fitEmulator; its effects are the library
%   OPTIONS     struct of gapOptions
%   TARGETS     1 x n, targets to use (default PROBLEM.used)
%   HYPOTHESES  struct
%     white      whitened emulator of the targets (formError)
%     prior      mean, sd (1 x p, parameters in [-1, 1]; sd Inf: uniform)
%     list, singles, pairPrior  of hypothesisTable
%     names, siblings (1 x K cells), options
%     reference  what the gate compares with (gapReference; []: not yet)

function hypotheses = makeHypotheses (problem, emulator, options, targets)
  if nargin < 4
    targets = problem.used;
  end
  budget = noiseBudget (problem, emulator);
  hypotheses.white = formError (problem, emulator, budget, targets);
  hypotheses.prior = problem.paramPrior;
  kinds = discrepancyKinds (problem, emulator, budget, targets);
  % the middle and five points towards the faces: the null fit may have several
  % valleys
  starts = [zeros(1, emulator.p); 0.9 * boxPoints(emulator.p, 5)];
  hypotheses.names = {emulator.effect.name};
  hypotheses.factor = ones (1, numel (hypotheses.names));
  for e = problem.effects
    hypotheses.factor(strcmp (hypotheses.names, e.name)) = e.factor;
  end
  hypotheses = hypothesisTable (hypotheses, kinds, starts);
  hypotheses.siblings = siblingsOf (problem, hypotheses.names);
  hypotheses.options = options;
  hypotheses.reference = [];
end

function siblings = siblingsOf (problem, names)
  siblings = cell (1, numel (names));
  for k = 1:numel (names)
    at = find (strcmp ({problem.effects.name}, names{k}), 1);
    siblings{k} = setdiff (problem.effects(at).siblings(:)', names);
  end
end

%!test
%! rand ('twister', 4); randn ('twister', 4);
%! lab = standInGap (0);
%! given = setfield (lab.problem, 'value', ones (1, 24));
%! given.paramMean = [0.5, NaN, NaN, NaN];
%! given.paramSd = [0.1, NaN, NaN, NaN];
%! hypotheses = labStudy (given, lab.plan (30, 3)).hypotheses;
%! assert (hypotheses.prior.sd, [0.2, Inf, Inf, Inf], 1e-12);
%! given.effects(1).factor = 0.05;
%! rare = labStudy (given, lab.plan (30, 3)).hypotheses;
%! assert (rare.list(2).prior / rare.list(3).prior, 0.05, 1e-12);
%! each = [hypotheses.list.h];
%! assert (sum (strcmp ({each.kind}, 'discrepancy')), 6);
%! assert (sum (hypotheses.white.shape), 1, 1e-9);
%! % a misfit of the first bench moves no target of another one, whichever way
%! % the coordinates of the effects are turned
%! row = hypotheses.list(find (strcmp ({each.kind}, 'discrepancy'))(2));
%! C = row.white.back * diag (row.white.shape) * row.white.back';
%! isOff = lab.problem.bench ~= lab.problem.bench(1);
%! assert (max (abs (C(isOff, isOff)(:))) < 1e-9 * max (abs (C(:))));
%! assert (C(1, 1) > 0);
%! assert (hypotheses.siblings{1}, cell (1, 0));

% SPDX-License-Identifier: GPL-3.0-only
