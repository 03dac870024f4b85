% HYPOTHESISTABLE  All that may explain the measurements: one row a hypothesis.
%
% CALL: HYPOTHESES = hypothesisTable (HYPOTHESES, KINDS, STARTS)
%
%   HYPOTHESES  struct white (whitenEmulator), prior (see viewHypothesis), factor
%           (1 x K, of the prior of each effect, see newEffect; default 1)
%   KINDS   1 x m struct of discrepancyKinds
%   STARTS  s x p, starts of the null fit, parameters in [-1, 1]
%   HYPOTHESES  the same with
%     list       1 x H struct: the null model, each single effect, each
%                discrepancy
%       h       of newHypothesis;  white  in whose coordinates it is fitted
%       prior   probability;  from  row whose fits it starts from (0: none)
%       starts  m x d, normal coordinates of the unknowns beyond those
%     singles    1 x K, rows of the single effects
%     pairPrior  K x K, probability of each pair of effects
%
% Order and priors of the rows are known here alone. Pairs are too many to be
% listed for every data set: caseEvidence adds the likely ones.
%
% No gap has 0.4, pairs 0.1 (none with less than two effects). The rest is
% shared as if two more causes existed that nobody has listed: a list of 2 is
% believed to be incomplete, one of 40 to hold the cause. A cause of another
% form than that of its law is that cause (newHypothesis). An effect that is
% unlikely beforehand (its factor) counts as that part of a cause, in pairs too.

function hypotheses = hypothesisTable (hypotheses, kinds, starts)
  white = hypotheses.white;
  prior = hypotheses.prior;
  K = numel (white.effect);
  factor = givenField (hypotheses, 'factor', ones (1, K));
  weights = priorWeights (K, sum (factor));
  null = newHypothesis ('null');
  unknowns = viewHypothesis (white, null, prior).unknowns;
  list = struct ('h', null, 'white', white, 'prior', weights.null, 'from', ...
                 0, 'starts', toNormal (unknowns, starts));
  for k = 1:K
    one = newHypothesis ('single', k);
    list(end + 1) = struct ('h', one, 'white', white, ...
                            'prior', weights.single * factor(k), 'from', 1, ...
                            'starts', startsOf (white, one, prior));
  end
  for kind = kinds
    list(end + 1) = struct ('h', kind.h, 'white', kind.white, ...
                            'prior', weights.discrepancy * kind.weight, ...
                            'from', 1, 'starts', 0);
  end
  hypotheses.list = list;
  hypotheses.singles = 1 + (1:K);
  % all pairs share one probability: a long list makes no pair likelier
  both = triu (factor' * factor, 1);
  hypotheses.pairPrior = weights.pair * (both + both') / ...
                     max (sum (both(:)), realmin);
end

% Probability of each kind of explanation, all of its members together; of the
% single effects that of one whose factor is 1. N: their factors together.
function weights = priorWeights (K, n)
  pair = 0.1 * (K > 1);
  rest = 0.6 - pair;
  whole = n + 2;
  weights = struct ('null', 0.4, 'single', rest / whole, 'pair', pair, ...
                    'discrepancy', rest * 2 / whole);
end

% Of the strength, the amplitude and the form error of a single effect.
function U = startsOf (white, h, prior)
  range = white.effect(h.members).range;
  % a weak and a strong one, or one a side: an effect that bends may fit at both
  phi = [0.15; 0.6] * range(2);
  if range(1) < 0
    phi = 0.6 * range(:);
  end
  unknowns = viewHypothesis (white, h, prior).unknowns;
  Q = [zeros(2, white.p), phi, zeros(2, 1), h.extent / 2 * ones(2, 1)];
  U = toNormal (unknowns, Q)(:, white.p + 1:end);
end

%!test
%! % whatever the number of effects, all is shared out; a longer list is
%! % believed to hold more of the causes
%! hypotheses = handMadeHypotheses ();
%! kinds = setfield (hypotheses.list(end), 'weight', 1);
%! one = hypotheses.white.effect(1);
%! for K = [0, 1, 2, 10]
%!   hypotheses.white.effect = repmat (one, 1, K);
%!   hypotheses = hypothesisTable (hypotheses, kinds, 0);
%!   assert (sum ([hypotheses.list.prior]) + ...
%!           sum (triu (hypotheses.pairPrior)(:)), 1, 1e-12);
%!   last(K + 1) = hypotheses.list(end).prior;
%!   assert (numel (hypotheses.list), 2 + K);
%!   assert (numel (hypotheses.singles), K);
%! end
%! assert (last(1), 0.6, 1e-12);
%! assert (last(11) < last(3));
%!test
%! % two of three are unlikely: as a part of a cause each, alone and in pairs
%! hypotheses = handMadeHypotheses ();
%! kinds = setfield (hypotheses.list(end), 'weight', 1);
%! hypotheses.white.effect = repmat (hypotheses.white.effect(1), 1, 3);
%! hypotheses.factor = [1, 0.05, 0.05];
%! hypotheses = hypothesisTable (hypotheses, kinds, 0);
%! p = [hypotheses.list.prior];
%! assert (sum (p) + sum (triu (hypotheses.pairPrior)(:)), 1, 1e-12);
%! assert (p(3:4) / p(2), [0.05, 0.05], 1e-12);
%! assert (hypotheses.pairPrior(2, 3) / hypotheses.pairPrior(1, 3), 0.05, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
