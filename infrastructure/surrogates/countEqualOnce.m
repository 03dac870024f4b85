% COUNTEQUALONCE  Results in which equal replicates of a model count as one run.
%
% CALL: [Z, ISREPEAT] = countEqualOnce (DATA, BENCH)
%
% DATA      struct of newData: X n x d, Z n x T, E n x v
% BENCH     1 x T, number of the model of each target
% Z         n x T, NaN for the results of a model that repeat, to the last bit,
%           those of an earlier run at the same set
% ISREPEAT  n x 1 logical: the row holds nothing but such results
%
% A model that does not use runSeed gives the same packing again and again: that
% tells nothing of its scatter. Two packings may give the same count of grains
% by chance, so this is said of a model only where no two of its runs at any one
% set differ.

function [Z, isRepeat] = countEqualOnce (data, bench)
  Z = data.Z;
  [~, ~, set] = unique ([data.X, data.E], 'rows');
  isKnown = isfinite (Z);
  for k = unique (bench)
    ofBench = bench == k;
    done = find (any (isKnown(:, ofBench), 2));
    results = Z(done, ofBench);
    results(isnan (results)) = Inf;                   % unique: NaN is no NaN
    [~, first] = unique ([set(done), results], 'rows', 'first');
    again = setdiff ((1:numel (done))', first);
    usesSeed = numel (first) > numel (unique (set(done)));
    if ~usesSeed
      Z(done(again), ofBench) = NaN;
    end
  end
  isRepeat = any (isKnown, 2) & ~any (isfinite (Z), 2);
end

%!test
%! % model 1 ignores its seed, model 2 does not
%! data = addRows (newData (1, 3), [1; 1; 2; 2; 3], ...
%!                 [5, 6, 1; 5, 6, 1; 7, NaN, 2; 7, NaN, 3; 5, 6, 1], ...
%!                 [1; 2; 1; 2; 1], 'plan');
%! [Z, isRepeat] = countEqualOnce (data, [1, 1, 2]);
%! assert (Z, [5, 6, 1; NaN, NaN, 1; 7, NaN, 2; NaN, NaN, 3; 5, 6, 1]);
%! assert (! any (isRepeat));
%! [Z, isRepeat] = countEqualOnce (keepRows (data, [1; 2; 5]), ...
%!                                 [1, 1, 2]);
%! assert (isRepeat, [false; true; false]);
%!test
%! % equal by chance once, and different elsewhere; a failed run is no repeat
%! data = addRows (newData (1, 1), [1; 1; 2; 2; 3; 3], ...
%!                 [5; 5; 7; 8; NaN; NaN], ones (6, 1), 'plan');
%! [Z, isRepeat] = countEqualOnce (data, 1);
%! assert (Z, data.Z);
%! assert (! any (isRepeat));

% SPDX-License-Identifier: GPL-3.0-only
