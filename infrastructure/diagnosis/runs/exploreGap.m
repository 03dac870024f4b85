% EXPLOREGAP  Makes the runs that a diagnosis wants before it judges.
%
% CALL: EXPLORED = exploreGap (GIVEN, DATA, OPTIONS, EVALUATE)
%
%   GIVEN, DATA, OPTIONS, EVALUATE  see diagnoseMatrices; with OPTIONS.explore
%             false nothing is run
%   EXPLORED  struct
%     problem, known     of enterRuns (with correlateSeries)
%     emulator       of emulate, fitted to all runs
%     state    of newGapState, with these runs; what is left may verify a cure
%     data     DATA with the new runs
%
% First runs that mend surrogates which contradict their own runs, then those of
% the effects (exploreEffects). A diagnosis of several conditions explores each
% before it judges any: what the runs for one tell of an effect counts in all.
%
% Errors: those of newProblem, enterRuns and fitEmulator
%
% See also: diagnoseMatrices, diagnoseCase, exploreEffects

function explored = exploreGap (given, data, options, evaluate)
  options = gapOptions (options);
  [problem, known] = enterRuns (given, data, options);
  state = newGapState (known, options, evaluate);
  allowed = state.evaluate;
  if ~options.explore
    state.evaluate = [];
  end
  [state, emulator] = improveSurrogates (problem, options, state);
  problem = correlateSeries (problem, emulator, options);
  emulator = emulateChange (emulator, problem);
  [state, emulator] = exploreEffects (problem, options, state, emulator);
  state.evaluate = allowed;
  explored = struct ('problem', problem, 'known', known, 'emulator', emulator, ...
                     'state', state, 'data', ...
                     withNewRuns (data, state, known, problem));
end

% Where the surrogates are to blame, runs near the fitted set come first.
function [state, emulator] = improveSurrogates (problem, options, state)
  for pass = 1:3
    emulator = emulate (problem, state.data, options);
    % half of the budget at most: effects need the rest
    n = min (2 * emulator.p + 2, floor (state.budget.sets / 2));
    if pass == 3 || n < 1 || isempty (state.evaluate)
      return
    end
    theta = calibrateNull (problem, emulator, options);
    side = sideSignals (problem, emulator, theta, options);
    if ~side.blameSurrogate && ~side.vague
      return
    end
    % nearer at the second time: the fitted set is better known then
    state = runNearNull (problem, state, theta, n, 0.8 / pass, ...
                         options.seed + pass);
  end
end

%!test
%! % runs are made, within what is allowed, and none where none may be made
%! pkg load stk
%! [given, data, means] = smallGapLab ();
%! randn ('twister', 1);
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]) + 0.2 * randn (1, 12);
%! neutral = all (data.E == 0, 2);
%! for field = {'X', 'E', 'Z', 'replicate'}
%!   data.(field{1}) = data.(field{1})(neutral, :);
%! end
%! options = struct ('twins', 60, 'bootstrap', 49, 'trend', 'affine', ...
%!                   'maxNewRuns', 30);
%! run = @(X, E, r) means (X, [E, zeros(rows (E), 1)]);
%! one = exploreGap (given, data, options, run);
%! n = rows (one.data.X) - rows (data.X);
%! assert (n > 4 && n <= 30);
%! assert ([one.state.budget.new, rows(one.data.Z)], [n, n + rows(data.Z)]);
%! assert (~isempty (one.state.evaluate));
%! options.explore = false;
%! two = exploreGap (given, one.data, options, run);
%! assert (two.state.budget.new, 0);
%! assert (isequaln (two.data, one.data));
%! assert (~isempty (two.state.evaluate));

% SPDX-License-Identifier: GPL-3.0-only
