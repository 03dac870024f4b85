% MIXTUREINFORMATION  What a measurement is expected to tell about its cause.
%
% CALL: [BITS, PAIR] = mixtureInformation (PARTS, P, KINDS)
%
%   PARTS  1 x h struct mean (1 x n), cov (n x n): what each hypothesis predicts
%   P      1 x h, their probabilities, sum 1
%   KINDS  1 x h, kind of each; hypotheses of one kind need not be told apart
%   BITS   expected information about the kind, by 1000 draws of each hypothesis
%          (Lindley 1956): sum_c P_c E_c [log N_c - log N], N_c the mixture of
%          kind c, N that of all
%   PAIR   1 x 2, the two kinds of which it tells most, were there only these,
%          weighted with the probability that it is one of them; [] for one kind

function [bits, pair] = mixtureInformation (parts, P, kinds)
  % the same draws for all that is compared: differences are no chance
  draws = integrationPoints (1000, numel (parts(1).mean), 23).normal;
  roots = arrayfun (@(part) chol (part.cov), parts, 'UniformOutput', false);
  list = unique (kinds(:)');
  weight = arrayfun (@(c) sum (P(kinds == c)), list);
  density = cell (1, numel (parts));
  for k = 1:numel (parts)
    X = parts(k).mean + draws * roots{k};
    L = zeros (rows (X), numel (parts));
    for j = 1:numel (parts)
      R = (X - parts(j).mean) / roots{j};
      L(:, j) = -0.5 * sum (R.^2, 2) - sum (log (diag (roots{j}))) + log (P(j));
    end
    for c = 1:numel (list)
      density{k}(:, c) = logSumExp (L(:, kinds == list(c)));
    end
  end
  [~, number] = ismember (kinds(:)', list);
  bits = among (1:numel (list), density, P, number, weight);
  pair = [];
  most = -1;
  for two = nchoosek (1:numel (list), min (2, numel (list)))'
    if numel (two) == 2
      told = sum (weight(two)) * among (two', density, P, number, weight);
      if told > most
        [most, pair] = deal (told, list(two));
      end
    end
  end
end

% Were the kinds SOME all that there are.
function bits = among (some, density, P, number, weight)
  whole = sum (weight(some));
  bits = 0;
  for k = find (ismember (number, some) & P > 0)
    ofKind = density{k}(:, number(k)) - log (weight(number(k)));
    together = logSumExp (density{k}(:, some)) - log (whole);
    bits = bits + P(k) / whole * mean (ofKind - together) / log (2);
  end
  % of draws it may come out negative, information never is
  bits = max (bits, 0);
end

%!test
%! % two kinds far apart: one bit; alike: none; a third one far off, of which a
%! % quarter is left: its entropy
%! at = @(m) struct ('mean', m, 'cov', eye (numel (m)));
%! [bits, pair] = mixtureInformation ([at(0), at(20)], [0.5, 0.5], [1, 2]);
%! assert (bits, 1, 1e-6);
%! assert (pair, [1, 2]);
%! assert (mixtureInformation ([at(3), at(3)], [0.5, 0.5], [1, 2]), 0, 1e-12);
%! [bits, pair] = mixtureInformation ([at(0), at(20), at(20)], ...
%!                                    [0.4, 0.35, 0.25], [1, 1, 2]);
%! assert (pair, [1, 2]);
%! together = mixtureInformation ([at([0, 0]), at([20, 0]), at([0, 20])], ...
%!                            [0.5, 0.25, 0.25], [4, 5, 6]);
%! assert (together, 1.5, 1e-6);
%! % one kind: nothing to tell
%! [bits, pair] = mixtureInformation ([at(0), at(9)], [0.5, 0.5], [1, 1]);
%! assert (bits, 0);
%! assert (isempty (pair));
%!test
%! % two of one spread, d apart: against the integral
%! d = 1.5;
%! x = linspace (-9, 9 + d, 20001);
%! f = exp (-x.^2 / 2) / sqrt (2 * pi);
%! g = exp (-(x - d).^2 / 2) / sqrt (2 * pi);
%! exact = trapz (x, f .* log2 (2 * f ./ (f + g)));
%! at = @(m) struct ('mean', m, 'cov', 1);
%! bits = mixtureInformation ([at(0), at(d)], [0.5, 0.5], [1, 2]);
%! assert (bits, exact, 0.03);

% SPDX-License-Identifier: GPL-3.0-only
