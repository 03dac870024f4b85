% BENCHCONFLICTS  Asks each bench whether it agrees with the others.
%
% CALL: CONFLICT = benchConflicts (GAPPROBLEM, EM, MODELS)
%
%   GAPPROBLEM, EM, MODELS  of newGapProblem, fitEmulator, makeHypotheses
%   CONFLICT  struct
%     bench (1 x B'), numbers of the benches that have used targets
%     pair (B' x B'): p-value of bench j predicted from bench i alone
%     odd (scalar): the bench in conflict with all others ([] if there is none)
%
% See also: crossPredict, locateGap

function conflict = benchConflicts (gapProblem, em, models)
  used = gapProblem.used;
  conflict.bench = unique (gapProblem.bench(used));
  n = numel (conflict.bench);
  conflict.pair = NaN (n);
  own = @(b) used(gapProblem.bench(used) == conflict.bench(b));
  for b = 1:n
    for a = setdiff (1:n, b)
      cross = crossPredict (gapProblem, em, models, own (a), own (b));
      conflict.pair(a, b) = cross.p;
    end
  end
  conflict.odd = oddBench (conflict, n, models.options.conflictAt);
end

% The odd one conflicts with every other, and no two others conflict.
function odd = oddBench (conflict, n, least)
  odd = [];
  clash = min (conflict.pair, conflict.pair') < least;
  for b = 1:n
    others = setdiff (1:n, b);
    if n > 2 && all (clash(b, others)) && ~any (any (clash(others, others)))
      odd = conflict.bench(b);
    end
  end
end

%!test
%! % one bench reads wrongly: it is the odd one
%! rand ('twister', 3); randn ('twister', 3);
%! lab = standInGap (0);
%! given = lab.gapProblem;
%! given.value = lab.means (0.4 * ones (1, 4), zeros (1, 10)) ...
%!           + sqrt (2) * lab.noiseSd .* randn (1, 24);
%! given.value(7:12) = given.value(7:12) + 6;
%! gapProblem = newGapProblem (given);
%! em = fitEmulator (gapProblem, lab.plan (30, 2), ...
%!                    gapOptions (struct ('trend', 'affine')));
%! options = gapOptions (struct ('trend', 'affine'));
%! models = makeHypotheses (gapProblem, em, options);
%! conflict = benchConflicts (gapProblem, em, models);
%! assert (conflict.odd, 2);
%! assert (isnan (diag (conflict.pair)));
