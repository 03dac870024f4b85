% PRIORWEIGHTS  Shares out the prior probability among kinds of explanation.
%
% CALL: WEIGHTS = priorWeights (K)
%
%   K        scalar, number of listed effects
%   WEIGHTS  struct: null, single, pair, sibling, discrepancy: probability of
%            each kind, all of its members together
%
% No gap 0.4, a pair 0.1 (none with less than two effects). The rest is shared
% as if four more causes existed that nobody has listed, half of which resemble
% a listed one: a list of 2 is believed to be incomplete, one of 40 to hold the
% cause.
%
% See also: makeModels

function weights = priorWeights (K)
  pair = 0.1 * (K > 1);
  rest = 0.6 - pair;
  alike = 2 * (K > 0);
  all = K + alike + 2;
  weights = struct ('null', 0.4, 'single', rest * K / all, 'pair', pair, ...
                    'sibling', rest * alike / all, ...
                    'discrepancy', rest * 2 / all);
end

%!test
%! for K = [0, 1, 2, 10, 40]
%!   w = priorWeights (K);
%!   assert (sum (cell2mat (struct2cell (w))), 1, 1e-12);
%! end
%! assert (priorWeights (10).discrepancy < priorWeights (2).discrepancy);
%! assert (priorWeights (0).discrepancy, 0.6);
