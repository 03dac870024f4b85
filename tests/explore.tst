% Which effects are run, until the verdict stands (exploreEffects): a laboratory of
% formulas with one planted cause, or none.

%!function [given, data, run] = laboratory (strength)
%!  pkg load stk
%!  [given, data, means] = smallGapLab ();
%!  data = keepRows (data, all (data.E == 0, 2));
%!  effects = newProblem (setfield (given, 'value', ones (1, 12))).effects;
%!  run = @(X, E, varargin) means (X, strengthOfValues (effects, E)) + ...
%!                          0.2 * randn (rows (X), 12);
%!  randn ('twister', 3);
%!  given.value = means ([0.4, 0.6], strength) + 0.2 * randn (1, 12);
%!endfunction
%!function [state, emulator] = explored (given, data, run, more = struct ())
%!  options = gapOptions (mergeFields (struct ('trend', 'affine', ...
%!                                             'maxNewRuns', 60), more));
%!  problem = setfield (newProblem (given), 'unit', ones (1, 12));
%!  state = newGapState (data, options, run);
%!  emulator = fitEmulator (problem, data, options);
%!  [state, emulator] = exploreEffects (problem, options, state, ...
%!                                emulateChange (emulator, problem));
%!endfunction
%!test
%! % one strong cause like no other: each effect once, four runs of two of them
%! [given, data, run] = laboratory ([0, 0, 0.7, 0, 0]);
%! [state, emulator] = explored (given, data, run);
%! assert (all ([emulator.effect(1:4).runs] >= 1));
%! assert (emulator.effect(3).runs >= 4);
%! assert (state.budget.new < 25);
%!test
%! % one that another effect resembles is not believed before that one has runs
%! % that tell its bend, however unlikely; what does the opposite is no such one
%! [given, data, run] = laboratory ([0.6, 0, 0, 0, 0]);
%! [state, emulator] = explored (given, data, run);
%! assert (all ([emulator.effect(1:2).runs] >= 8));
%! assert (any ([emulator.effect(3:4).runs] < 8));
%! opposite = @(X, E, varargin) run (X, [E(:, 1) - E(:, 2), 0 * E(:, 2), ...
%!                                       E(:, 3:4)]);
%! [state, emulator] = explored (given, data, opposite);
%! assert (emulator.effect(2).runs < 8);
%!test
%! % what gives no result above a strength of 0.4 is run at a quarter
%! [given, data, run] = laboratory (zeros (1, 5));
%! jams = @(X, E, varargin) run (X, E) + 0 ./ (E(:, 3) < 0.46);
%! [state, emulator] = explored (given, data, jams);
%! assert (emulator.effect(3).runs, 1);
%! assert (emulator.effect(3).strongest, 0.25, 1e-9);
%! assert ([state.budget.new, state.budget.failed], [6, 2]);
%!test
%! % a weak cause behind surrogates of nine runs (seeded): in doubt neutral sets
%! % near the null come first, then those of effects
%! [given, data, run] = laboratory ([0, 0, 0.13, 0, 0]);
%! few = keepRows (data, 1:9);
%! neutral = @(state) all (state.data.E == 0, 2)';
%! [state, emulator] = explored (given, few, run);
%! assert (find (neutral (state)), [1:9, 14:20]);
%! assert (all (range (state.data.X(14:20, :)) < 0.5));
%! % three of the plan lay near it already; a second start asks for no more
%! options = gapOptions (struct ('trend', 'affine', 'maxNewRuns', 60));
%! again = exploreEffects (newProblem (given), options, ...
%!                         setfield (state, 'budget', 'sets', 60), emulator);
%! assert (again.budget.new, state.budget.new);
%! % whatever its p, none of a change
%! more = struct ('seekAt', 1.1, 'significance', 0);
%! assert (sum (neutral (explored (given, few, run, more))) > 9);
%! given.reference = struct ('value', given.value, 'sd', given.sd, 'trials', ...
%!                           ones (1, 12), 'scatter', false (1, 12), ...
%!                           'perCondition', [false, false]);
%! assert (sum (neutral (explored (given, few, run, more))), 9);

% SPDX-License-Identifier: GPL-3.0-only
