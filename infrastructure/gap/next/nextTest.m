% NEXTTEST  Ranks further measurements by what they would tell about the cause.
%
% CALL: TESTS = nextTest (GAPPROBLEM, EM, W, P)
%
%   GAPPROBLEM  struct of newGapProblem
%   EM          struct of fitEmulator, the effects as in W
%   W           struct of caseEvidence (members, posterior, kind)
%   P           1 x H, probabilities of the hypotheses
%   TESTS       1 x m struct, best first: test (text), targets, gain (bits about
%               which hypothesis holds), cost, gainPerCost
%
% Candidates: every simulated but unmeasured setting (bench and coordinate; a
% curve as a whole), and every bench measured once more.
% gain = H (sum_k P_k N_k) - sum_k P_k H (N_k) with N_k the posterior predictive
% of hypothesis k (surrogate, packing and measurement in it), by 1000 draws
% (Lindley 1956; Box and Hill 1967).
%
% See also: diagnoseMatrices

function tests = nextTest (gapProblem, em, w, P)
  tests = candidates (gapProblem);
  [keep, P] = likelyOnes (w, P);
  budget = noiseBudget (gapProblem, em);
  noise = budget.covariance;
  for i = 1:numel (tests)
    at = tests(i).targets;
    parts = struct ('mean', {}, 'cov', {});
    for k = 1:numel (keep)
      parts(k) = predictive (em, w, keep(k), at, noise);
    end
    tests(i).gain = information (parts, P) / log (2);
    tests(i).gainPerCost = tests(i).gain / tests(i).cost;
  end
  [~, order] = sort (-[tests.gainPerCost]);
  tests = tests(order);
end

% The listed hypotheses among which a test could tell. Where an unlisted cause
% is certain, the likeliest of them stays: nothing is left to tell.
function [keep, P] = likelyOnes (w, P)
  listed = ismember (w.kind, {'null', 'single', 'pair'});
  listed = find (listed & ~cellfun (@(p) isempty (p.Q), w.posterior));
  P = P / max (sum (P(listed)), realmin);
  keep = listed(P(listed) > 0.005);
  if isempty (keep)
    [~, best] = max (P(listed));
    keep = listed(best);
    P(keep) = 1;
  end
  P = P(keep) / sum (P(keep));
end

function tests = candidates (gapProblem)
  tests = struct ('test', {}, 'targets', {}, 'gain', {}, 'cost', {}, ...
                  'gainPerCost', {});
  settings = [gapProblem.bench(:), gapProblem.coordinate(:), ...
              gapProblem.curve(:)];
  settings(gapProblem.curve > 0, 2) = 0;
  settings = settings(gapProblem.possible, :);
  for row = unique (settings, 'rows')'
    at = gapProblem.possible(all (settings == row', 2));
    names = strjoin (gapProblem.targetNames(at), ', ');
    if numel (at) > 3 && row(3) > 0
      names = sprintf ('%s to %s', gapProblem.targetNames{at([1, end])});
    end
    text = sprintf ('%s: measure %s', gapProblem.benchNames{row(1)}, names);
    tests(end + 1) = newTest (text, at, gapProblem.benchCost(row(1)));
  end
  for b = unique (gapProblem.bench(gapProblem.used))
    at = gapProblem.used(gapProblem.bench(gapProblem.used) == b);
    text = ['measure ', gapProblem.benchNames{b}, ' once more'];
    tests(end + 1) = newTest (text, at, gapProblem.benchCost(b));
  end
end

function test = newTest (text, targets, cost)
  test = struct ('test', text, 'targets', targets, 'gain', 0, ...
                 'cost', cost, 'gainPerCost', 0);
end

function part = predictive (em, w, h, at, noise)
  posterior = w.posterior{h};
  Q = posterior.Q;
  M = predictGap (em, w.members{h}, Q(:, 1:em.p + numel (w.members{h})));
  M = M(:, at);
  part.mean = posterior.weight' * M;
  D = (M - part.mean) .* sqrt (posterior.weight);
  known = diag (mean (em.surrogateVar(:, at), 1) + em.fitVar(at));
  part.cov = D' * D + noise(at, at) + known;
end

% Mutual information of a Gaussian mixture: E [log N_k (x) - log sum P N (x)].
function bits = information (parts, P)
  draws = integrationPoints (1000, numel (parts(1).mean), 23).normal;
  bits = 0;
  for k = 1:numel (parts)
    X = parts(k).mean + draws * chol (parts(k).cov);
    L = zeros (rows (X), numel (parts));
    for j = 1:numel (parts)
      R = (X - parts(j).mean) / chol (parts(j).cov);
      L(:, j) = -0.5 * sum (R.^2, 2) - sum (log (diag (chol (parts(j).cov))));
    end
    bits = bits + P(k) * mean (L(:, k) - logSumExp (L + log (P)));
  end
  bits = max (bits, 0);
end

%!test
%! % two causes that only the unmeasured target tells apart: nearly one bit
%! e = struct ('name', {'a', 'b'}, 'powers', [0, 1], ...
%!             'coef', {[5, 9, 1], [5, -9, 1]}, 'laboratory', true, 'bend', 1);
%! em = struct ('p', 1, 'powers', [0; 1], 'coef', [0, 0, 0; 1, 0, 0], ...
%!              'effect', e, 'surrogateVar', zeros (2, 3), ...
%!              'fitVar', zeros (1, 3), 'noiseVar', ones (1, 3), ...
%!              'correlation', eye (3), 'range', ones (1, 3));
%! gapProblem = newGapProblem (struct ('value', [5, NaN, 1], ...
%!                                     'sd', ones (1, 3), ...
%!                                     'bench', [1, 2, 1], 'limits', [0; 1]));
%! w.members = {1, 2};
%! w.kind = {'single', 'single'};
%! w.posterior = repmat ({struct('Q', [0, 1], 'weight', 1)}, 1, 2);
%! tests = nextTest (gapProblem, em, w, [0.5, 0.5]);
%! assert (tests(1).targets, 2);
%! assert (tests(1).gain, 1, 0.01);
%! assert (tests(2).gain, 0, 1e-6);
%! % points of one curve are measured together
%! two = gapProblem;
%! [two.value(3), two.coordinate] = deal (NaN, [0, 1, 2]);
%! two.bench = [1, 2, 2];
%! two.possible = [2, 3];
%! two.used = 1;
%! assert (numel (nextTest (two, em, w, [0.5, 0.5])), 3);
%! two.curve = [0, 1, 1];
%! tests = nextTest (two, em, w, [0.5, 0.5]);
%! assert ({tests.targets}, {[2, 3], 1});
%! tests = nextTest (gapProblem, em, w, [0.5, 0.5]);
%! w.kind{3} = 'discrepancy';
%! w.posterior{3} = struct ('Q', [], 'weight', []);
%! tests = nextTest (gapProblem, em, w, [0, 0, 1]);
%! assert ([tests.gain], zeros (1, numel (tests)), 1e-12);
