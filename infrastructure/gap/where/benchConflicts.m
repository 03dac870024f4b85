% BENCHCONFLICTS  Asks each bench whether it agrees with the others.
%
% CALL: CONFLICT = benchConflicts (GAPPROBLEM, EM, MODELS)
%
%   GAPPROBLEM, EM, MODELS  of newGapProblem, fitEmulator, makeHypotheses
%   CONFLICT  struct
%     bench (1 x B'), numbers of the benches that have used targets
%     leaveOut (1 x B'): p-value of a bench predicted from all others
%     holm (1 x B'): the same, corrected for asking B' times (Holm 1979)
%     pair (B' x B'): p-value of bench j predicted from bench i alone
%     odd (scalar): the bench in conflict with all others ([] if there is none)
%
% See also: crossPredict, locateGap

function conflict = benchConflicts (gapProblem, em, models)
  used = gapProblem.used;
  conflict.bench = unique (gapProblem.bench(used));
  n = numel (conflict.bench);
  conflict.leaveOut = ones (1, n);
  conflict.pair = NaN (n);
  own = @(b) used(gapProblem.bench(used) == conflict.bench(b));
  for b = 1:n
    rest = setdiff (used, own (b));
    if ~isempty (rest)
      cross = crossPredict (gapProblem, em, models, rest, own (b));
      conflict.leaveOut(b) = cross.p;
    end
    for a = setdiff (1:n, b)
      cross = crossPredict (gapProblem, em, models, own (a), own (b));
      conflict.pair(a, b) = cross.p;
    end
  end
  conflict.holm = holm (conflict.leaveOut);
  conflict.odd = oddBench (conflict, n);
end

function adjusted = holm (p)
  [sorted, order] = sort (p);
  n = numel (p);
  adjusted = zeros (1, n);
  adjusted(order) = min (cummax (sorted .* (n:-1:1)), 1);
end

% The odd one conflicts with every other, and no two others conflict.
function odd = oddBench (conflict, n)
  odd = [];
  clash = min (conflict.pair, conflict.pair') < 0.01;
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
%! assert (conflict.holm(2) < 0.01);
