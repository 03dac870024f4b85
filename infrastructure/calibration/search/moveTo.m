% MOVETO  Lets another set take the found one's place, where it is worth it.
%
% CALL: [STATE, WASWRONG] = moveTo (STATE, PROBLEM [, P])
%
% STATE     struct of newState; its found set is described anew with its
%           surrogates
% P         1 x d, another set (default: the surest one, calibrateOnKriging;
%           also says which targets no set meets together)
% WASWRONG  logical: it was taken as the found set had turned out wrong. Any
%           other step goes along slopes that the surrogates know
%
% The found set stays once it is sure enough (options.confidence), and unless
% the other one is likelier by options.better: what the runs at it told the
% surrogates they go on telling. A set whose runs fail too often is left
% (failedSets).

function [state, wasWrong] = moveTo (state, problem, p)
  problem = withCare (state, problem);
  here = describeSet (state.surrogates, problem, state.found.params);
  there = here;
  if here.probability >= problem.options.confidence
    here.conflict = {};
  elseif nargin > 2
    there = describeSet (state.surrogates, problem, p);
  else
    there = calibrateOnKriging (state.surrogates, problem, here.params);
    here.conflict = there.conflict;
  end
  isWrong = here.probability <= problem.options.wrong;
  if isWrong || here.probability <= there.probability - problem.options.better
    here = there;
  end
  wasWrong = isWrong && ~sameSet (here.params, state.found.params, ...
                                  problem.limits);
  state.found = mergeFields (state.found, here);
end

%!test
%! % a sure set stays to the last digit; one whose runs fail is left
%! [problem, state, s] = smallCalibration ();
%! p = toDigits (surestSet (s, problem, zeros (0, 2)));
%! state.found.params = p;
%! other = toDigits (p + [0.05, 0]);
%! [out, wasWrong] = moveTo (state, problem, other);
%! assert (! wasWrong);
%! assert (out.found.params, p);
%! assert (out.found.probability, meetProbability (s, problem, p), 1e-12);
%! state.data = addRows (state.data, repmat (p, 2, 1), NaN (2, 2), [1; 2], ...
%!                       'verify');
%! [away, wasWrong] = moveTo (state, problem, other);
%! assert (wasWrong);
%! assert (away.found.params, other);

% SPDX-License-Identifier: GPL-3.0-only
