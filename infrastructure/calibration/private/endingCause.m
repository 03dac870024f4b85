% ENDINGCAUSE  What kept a calibration from a confirmed set, beside its budget.
%
% CALL: FINAL = endingCause (FINAL, STATE, PROBLEM)
%
% FINAL    see confirmSet
% STATE    struct of newState;  PROBLEM  see newProblem
% FINAL    with another ending (newEnding) where the set is not confirmed and
%          'cutOff'      a fifth of the runs or more, and two at least, were cut
%                        off at a time limit: what lies there is not known
%          'manyFailed'  a third or more, and three at least, failed otherwise
%          'jump'        a response passes its target in a jump (jumpsPast):
%                        more runs find no set in it. A run that looks wrong
%                        and was not made once more proves no jump
%          'beyondScatter'  three runs or more at the set miss by more than their
%                        scatter explains (chance below 1 %), and nothing that was
%                        not run is expected to do better: no number of runs helps

function final = endingCause (final, state, problem)
  if final.converged || strcmp (final.ending.code, 'published')
    return
  end
  budget = state.budget;
  cutOff = givenField (budget, 'cutOff', 0);
  numbers = struct ('limit', final.limit, 'runs', final.n, ...
                    'cutOff', cutOff, 'failed', budget.failed - cutOff, ...
                    'total', budget.new + budget.reused, ...
                    'seconds', ceil (-min ([budget.seconds{:}, 0])));
  state.data = keepRows (state.data, ~openSuspects (state, problem));
  [jump, names] = jumpsPast (state, problem);
  code = '';
  if cutOff >= max (2, 0.2 * numbers.total)
    code = 'cutOff';
  elseif numbers.failed >= max (3, numbers.total / 3) && ...
         ~strcmp (final.ending.code, 'noResult')
    code = 'manyFailed';
  elseif ~isempty (names)
    code = 'jump';
    numbers = mergeFields (numbers, jump);
    numbers.names = names;
  elseif any (strcmp (final.ending.code, {'outside', 'open'})) && final.n > 2 && ...
         final.probability < 0.01 && isempty (final.untested)
    code = 'beyondScatter';
    numbers.names = missedNames (final, problem);
  end
  if ~isempty (code)
    final.ending = newEnding (code, numbers, problem.options);
    final.reason = final.ending.text;
  end
end

function names = missedNames (final, problem)
  [groups, names] = requirementsOf (problem);
  names = names(cellfun (@(g) ~all (final.met(g)), groups));
end

%!shared problem, state, final
%! [problem, state, ~, law] = smallCalibration ();
%! problem.value = [4, 1.9];
%! problem.options.maxFunEvals = 0;
%! final = confirmSet (state, problem);
%! state.budget = mergeFields (state.budget, struct ('new', 20, 'failed', 5));
%!test
%! assert (endingCause (final, state, problem), final);
%! cut = setfield (state, 'budget', 'cutOff', 5);
%! cut.budget.seconds = {[1, -60, -120]};
%! f = endingCause (final, cut, problem);
%! assert ({f.ending.code, f.ending.cutOff}, {'cutOff', 5});
%! assert (! isempty (strfind (f.reason, '5 of 20 runs')));
%! assert (! isempty (strfind (f.reason, '120 s')));
%! lost = setfield (state, 'budget', 'failed', 7);
%! assert (endingCause (final, lost, problem).ending.code, 'manyFailed');
%! sure = setfield (final, 'converged', true);
%! assert (endingCause (sure, cut, problem), sure);
%!test
%! X = [state.data.X; 0.5, 1; 0.51, 1.01];
%! Z = [3 + X(:, 1), 1 + (X(:, 1) > 0.505)];
%! s = state;
%! s.data = addRows (newData (2, 2), X, Z, ones (14, 1), 'plan');
%! problem.value = [3.5, 1.5];
%! f = endingCause (final, s, problem);
%! assert ({f.ending.code, f.ending.names}, {'jump', {'y'}});
%! s.surrogates(1).suspect(14) = true;
%! s.surrogates(2).suspect(14) = false;
%! assert (endingCause (final, s, problem), final);
%!test
%! % 30 runs of the set miss by three standard errors; nothing else is expected to do better
%! problem = smallProblem (1, 0.05);
%! final = struct ('converged', false, 'ending', newEnding ('outside', struct ()), ...
%!                 'limit', 'maxFunEvals', 'n', 30, 'probability', 0.001, ...
%!                 'untested', zeros (0, 1), 'met', false, 'reason', '');
%! X = (0:9)' / 9;
%! data = addRows (newData (1, 1), X, 2 + 0 * X + 0.01 * sin (40 * X), ones (10, 1), 'plan');
%! state = newState (data, fitSurrogates (data, problem), []);
%! state.budget.seconds = {};
%! ending = @(final) endingCause (final, state, problem).ending;
%! assert ({ending(final).code, ending(final).names}, ...
%!         {'beyondScatter', problem.targetNames});
%! assert (ending (setfield (final, 'untested', 0.5)).code, 'outside');
%! assert (ending (setfield (final, 'n', 1)).code, 'outside');

% SPDX-License-Identifier: GPL-3.0-only
