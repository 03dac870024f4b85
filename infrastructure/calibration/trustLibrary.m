% TRUSTLIBRARY  Holds runs of other cases against a new one before they count.
%
% CALL: STATE = trustLibrary (STATE, PROBLEM, SAY)
%
%   STATE    see newState; its data come back with the rows that were run, and
%            without those of the library where they do not say what the bench
%            gives today: its misled says so then (checkSurrogates)
%
% The set that the library finds is run: it must be run anyway. Where a result
% is off by more than 4 standard deviations of what the library foretells, and
% by more than half of the tolerance, the set is run once more, since a single
% run may be wrong. Off again, the library misleads: a wall that was changed
% outside the model folder, another program behind the same name.

function state = trustLibrary (state, problem, say)
  old = keepRows (state.data, strcmp (state.data.stage, 'library'));
  least = numel (problem.names) + 2;
  if finishedSets (runsThatCount (old, problem)) < least
    return
  end
  surrogates = fitSurrogates (old, problem);
  p = calibrateOnKriging (surrogates, problem).params;
  [m, v] = predictSurrogate (surrogates, p);
  sd = sqrt (v + [surrogates.noiseVar]);
  for attempt = 1:2
    before = rows (state.data.X);
    state = addRuns (state, problem, p, [], 'plan');
    z = state.data.Z(before + 1:end, :);
    known = isfinite (z);
    if ~any (known)
      return                             % no budget, or the run failed
    end
    off = abs (z - m) ./ sd;
    off(abs (z - m) < problem.tol .* abs (problem.scale) / 2) = 0;
    [worst, t] = max (off(known));
    if worst <= 4
      say (sprintf (['library   a new run at the values that it finds gives ' ...
                     'what it predicts (off by %.1f standard ' ...
                     'deviations)'], worst));
      return
    end
  end
  t = find (known)(t);
  state.misled = sprintf (['stored runs of other cases are not used: for ' ...
                           '%s they predict %.4g, two new runs with these ' ...
                           'values gave another value, the last %.4g ' ...
                           '(%.0f standard deviations). Something outside ' ...
                           'the model folder has changed. ' ...
                           'decalioc forget takes them out of use'], ...
                          problem.targetNames{t}, m(t), z(t), worst);
  say (['library   ', state.misled]);
  state.data = keepRows (state.data, ~strcmp (state.data.stage, 'library'));
end

%!function [data, misled] = trusted (data, problem, f)
%!  state = newState (data);
%!  state.evaluate = newEvaluate (f);
%!  state = trustLibrary (state, problem, @(text) []);
%!  [data, misled] = deal (state.data, state.misled);
%!endfunction

%!shared problem, data, f
%! rand ('twister', 2);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('name', {'x', 'y'}, 'value', {2, 0.1}, ...
%!                                'tol', 0.01, 'model', 1));
%! problem = newProblem (C, []);
%! f = @(P, varargin) [1 + sum(P, 2), P(:, 1) - P(:, 2)];
%! X = rand (9, 2);
%! data = addRows (newData (2, 2), X, f (X), ones (9, 1), 'library');
%!test
%! [out, text] = trusted (data, problem, f);
%! assert (out.stage(9:end), {'library'; 'plan'});
%! assert (text, '');
%! assert (f (out.X(10, :)), [2, 0.1], 0.02);
%!test
%! % another wall: dropped after a second look, and said
%! [out, text] = trusted (data, problem, @(varargin) 1.2 * f (varargin{:}));
%! assert (out.stage, {'plan'; 'plan'});
%! assert (out.replicate, [1; 2]);
%! assert (strncmp (text, 'stored runs of other cases are not used', 39));
%!test
%! % one wrong run; no budget; too few runs to tell
%! once = @(P, E, r) (1 + 0.3 * (r == 1)) * f (P);
%! [out, text] = trusted (data, problem, once);
%! assert (rows (out.X), 11);
%! assert (text, '');
%! assert (trusted (data, problem, @(varargin) [NA, NA]), data);
%! assert (trusted (keepRows (data, 1:3), problem, f), keepRows (data, 1:3));
