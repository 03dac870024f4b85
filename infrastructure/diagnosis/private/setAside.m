% SETASIDE  Leaves out the readings of a change that the model cannot follow.
%
% CALL: [PROBLEM, EMULATOR] = setAside (PROBLEM, EMULATOR, OPTIONS)
%
%   PROBLEM   struct of newProblem; the readings that are left out are marked in aside,
%             and are not in used. Without a reference it stays as it is
%   EMULATOR  of emulateChange, then of that without them
%   OPTIONS   struct of gapOptions: asideAt, asideShare
%
% The fitted model gives at the reference what was measured there, or it misses it. It
% cannot follow the reading where the miss is beyond the tolerance by more than asideAt
% standard deviations (of the measurement and of the surrogates), and more than
% asideShare of what the parameters move that reading: then what a cause does to it in
% the model says little of what it does in the rig. The worst go first, with those that
% are half as bad, and the rest is fitted anew: one bad reading drags others along. The
% one that is followed best stays.
%
% See also: emulateChange, studyGap

function [problem, emulator] = setAside (problem, emulator, options)
  if isempty (problem.reference)
    return
  end
  allowed = problem.tol .* abs (problem.scale);
  isJudged = false (size (problem.value));
  isJudged(problem.used) = isfinite (problem.reference.value(problem.used));
  while sum (isJudged & ~problem.aside) > 1
    miss = abs (problem.reference.value - emulator.change.simulated);
    excess = (miss - allowed) ./ emulator.change.missSd;
    excess(~isJudged | problem.aside) = -Inf;
    isFar = excess > options.asideAt & miss > options.asideShare * emulator.range;
    if ~any (isFar)
      return
    end
    isOut = isFar & excess >= max (excess(isFar)) / 2;
    left = find (isJudged & ~problem.aside);
    if all (isOut(left))
      [~, best] = min (excess(left));
      isOut(left(best)) = false;
    end
    problem.aside = problem.aside | isOut;
    problem.used = problem.used(~problem.aside(problem.used));
    emulator = emulateChange (emulator, problem);
  end
end

%!shared emulator, given, options
%! options = struct ('asideAt', 2, 'asideShare', 1 / 3);
%! emulator = handMadeEmulator ([0, 0, 0, 0; 3, 1, 0, 0]);
%! emulator.range = 10 * ones (1, 4);
%! emulator.noiseVar(:) = 1e-6;
%! given = struct ('value', zeros (1, 4), 'sd', 0.1 * ones (1, 4), 'limits', [0; 1], ...
%!                 'bench', ones (1, 4), 'tol', 0.2 * ones (1, 4), 'scale', ones (1, 4));
%! given.reference = struct ('value', [1.5, 0.5, 5, 0.3], 'sd', 0.1 * ones (1, 4));
%!test
%! % the parameter follows the first two, the fourth is met within tolerance and
%! % noise, the third is off
%! problem = newProblem (given);
%! [problem, new] = setAside (problem, emulateChange (emulator, problem), options);
%! assert (problem.aside, [false, false, true, false]);
%! assert (problem.used, [1, 2, 4]);
%! assert (new.change.simulated, [1.5, 0.5, 0, 0], 0.1);
%! % as a problem that is built anew
%! assert (newProblem (problem).used, [1, 2, 4]);
%!test
%! % within a wider tolerance all are followed; without a reference nothing is asked
%! wide = setfield (given, 'tol', {3}, 5.5);
%! problem = newProblem (wide);
%! assert (setAside (problem, emulateChange (emulator, problem), options).used, 1:4);
%! wide.reference = [];
%! assert (setAside (newProblem (wide), emulator, options).used, 1:4);
%!test
%! % a miss that is small beside what parameters move is the lack of any model
%! problem = newProblem (given);
%! wide = setfield (emulator, 'range', 20 * ones (1, 4));
%! assert (setAside (problem, emulateChange (wide, problem), options).used, 1:4);
%!test
%! % a model that follows nothing: one reading stays
%! given.reference = struct ('value', [9, -8, 5, 7], 'sd', 0.1 * ones (1, 4));
%! problem = newProblem (given);
%! assert (numel (setAside (problem, emulateChange (emulator, problem), options).used) == 1);

% SPDX-License-Identifier: GPL-3.0-only
