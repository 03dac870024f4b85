% BENTSTANDIN  Stand-ins whose response bends, jumps or has two outcomes.
%
% CALL: S = bentStandIn (name, seed)
%
% name  two parameters, two targets each:
%       'exponential': a response that grows 20- to 60-fold over the box;
%       'threshold': one that jumps within 4 to 12 % of the box;
%       'peak': one that is flat but for a peak of half width 5 to 20 %;
%       'decades': one parameter over four decades, in logarithms;
%       'ordered': a run fails where the first is not below the second, and
%       such sets are not allowed;
%       'clogging': as bends go none, but a run ends in another way with a
%       chance that grows from 0 to 60 % along a parameter: it gives 10 to 60 %
%       of what it gives else; 'cloggingTold': the same with what 120 earlier runs of
%       the rig say of that (S.others, as form.csv tells it, see knownShapes)
% seed  integer: another truth and another shape with each one
% S     see standIn, with tol 1 x 2 (relative) and truth 1 x 2; of clogging
%       response is the mean over both outcomes, and flow (handle) that of the
%       usual one, chance (handle, n x 2 -> n x 1) that of the other one and
%       part (what it gives then)
%
% See also: standIn, bends

function S = bentStandIn (name, seed)
  rand ('twister', 2e6 + seed);
  shape = rand (1, 4);
  S = struct ('name', name, 'noise', 0.01, 'tol', [0.04, 0.03], ...
              'model', [1, 1], 'names', {{'a', 'b'}}, ...
              'limits', [0, 0; 1, 1], 'targetNames', {{'first', 'second'}});
  switch name
    case 'exponential'
      rate = 3 + 1.1 * shape(1);
      S.response = @(P) [exp(rate * P(:, 1)) .* (1 + 0.5 * P(:, 2)), ...
                         2 + P(:, 1) + P(:, 2)];
    case 'threshold'
      [at, width] = deal (0.2 + 0.6 * shape(1), 0.01 + 0.02 * shape(2));
      S.response = @(P) [20 + 30 ./ (1 + exp ((at - P(:, 1)) / width)) + ...
                         8 * P(:, 2), 50 - 15 * P(:, 1) + 20 * P(:, 2)];
    case 'peak'
      [at, width] = deal (0.15 + 0.7 * shape(1), 0.05 + 0.15 * shape(2));
      S.response = @(P) [1 + 9 * exp(-((P(:, 1) - at) / width).^2), ...
                         2 + P(:, 1) + P(:, 2)];
    case 'decades'
      S.names = {'E', 'mu'};
      S.limits = [1e5, 0.1; 1e9, 0.9; 1, 0];
      S.response = @(P) [20 + 5 * log10(P(:, 1)) + 10 * P(:, 2), ...
                         100 * exp(-3 * P(:, 2)) ./ ...
                         (1 + P(:, 1) / 1e7).^0.3];
    case 'ordered'
      S.response = @(P) [3 + P(:, 1) + 2 * P(:, 2), ...
                         3 + 2 * P(:, 1) - P(:, 2) / 2] + ...
                        0 ./ (P(:, 1) < P(:, 2));
      sample = sort (sampleBox (300, S.limits), 2);
      S.allowed = struct ('values', {{[], []}}, 'sample', sample, ...
                          'rules', {{@(P) P(:, 1) < P(:, 2)}});
    case 'clogging'
      S = clogging (S, shape);
    case 'cloggingTold'
      S = clogging (S, shape);
      S.others = othersOf (S);
    otherwise
      error ('DEcalioc:bentStandIn:unknownName', ...
             ['bentStandIn: NAME must be exponential, threshold, peak, ' ...
              'decades, ordered, clogging or cloggingTold, got %s.'], name);
  end
  S = withTruth (S, shape);
end

function S = clogging (S, shape)
  S.tol = [0.05, 0.05];
  S.noise = 0.02;
  S.part = [0.1 + 0.5 * shape(1), 1];
  S.flow = @(P) [5 + 4 * P(:, 1) - 2 * P(:, 2), 3 + P(:, 1) + 2 * P(:, 2)];
  at = 0.35 + 0.5 * shape(2);
  S.chance = @(P) 0.6 ./ (1 + exp ((at - P(:, 2)) / 0.08));
  S.response = @(P) S.flow (P) .* (1 - S.chance (P) * (1 - S.part));
end

% Where and how often earlier runs clogged, and what they gave then.
function others = othersOf (S)
  P = fromUnit (rand (120, 2), S.limits);
  is = rand (120, 1) < S.chance (P);
  others = struct ('low', min (P(is, :), [], 1), 'high', max (P(is, :), [], 1), ...
                   'times', S.part);
  isThere = all (P >= others.low & P <= others.high, 2);
  others.share = sum (is) / sum (isThere);
end

% The truth anywhere in the box; with a peak on its flank, where it can be seen.
function S = withTruth (S, shape)
  u = shape(3:4);
  if strcmp (S.name, 'ordered')
    u = sort (u);
  end
  S.truth = fromUnit (u, S.limits);
  if strcmp (S.name, 'peak')
    half = (0.05 + 0.15 * shape(2)) * (0.3 + u(1));
    S.truth(1) = 0.15 + 0.7 * shape(1) + half * sign (u(1) - 0.5);
    S.truth(1) = min (max (S.truth(1), 0), 1);
  end
  S.value = S.response (S.truth);
  if isfield (S, 'flow')
    S.value = S.flow (S.truth);
  end
end

%!test  % inside the box, and every parameter moves a response
%! for name = {'exponential', 'threshold', 'peak', 'decades', 'ordered', ...
%!              'clogging', 'cloggingTold'}
%!   for seed = 1:5
%!     S = bentStandIn (name{1}, seed);
%!     assert (all (S.truth >= S.limits(1, :) & S.truth <= S.limits(2, :)));
%!     assert (size (S.response ([S.truth; S.truth])), [2, 2]);
%!   end
%! end
%! S = bentStandIn ('clogging', 2);
%! chance = S.chance ([0, 0; 0, 1]);
%! assert (chance(1) < 0.02 && chance(2) > 0.3);
%!error id=DEcalioc:bentStandIn:unknownName bentStandIn ('flat', 1)

% SPDX-License-Identifier: GPL-3.0-only
