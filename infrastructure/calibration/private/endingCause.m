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
  end
  if ~isempty (code)
    final.ending = newEnding (code, numbers, problem.options);
    final.reason = final.ending.text;
  end
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
