% TRUSTLIBRARY  Holds runs of another source against a new one before they count.
%
% CALL: STATE = trustLibrary (STATE, PROBLEM, SAY)
%
%   STATE    see newState; its data come back with the rows that were run, and
%            without those of a source (stage 'library': stored runs of other
%            cases; 'import': rows of runs.csv) that does not say what the model
%            gives today (keepApart). Its others: 1 x n struct source, surrogates (of
%            its runs alone), search (found, history: calibrateOnKriging on these),
%            those that count
%
% The set that a source finds is run: it must be run anyway. Unless a shift of the
% source is three times as likely as chance (oddsOfShift) it is taken in; else the
% set is run again, at most four times.

function state = trustLibrary (state, problem, say)
  for source = {'library', 'import'}
    old = keepRows (state.data, strcmp (state.data.stage, source{1}));
    if finishedSets (runsThatCount (old, problem)) > numel (problem.names) + 1
      other = struct ('source', source{1}, 'surrogates', fitSurrogates (old, problem), ...
                      'search', []);
      [found, history] = calibrateOnKriging (other.surrogates, problem);
      other.search = struct ('found', found, 'history', {history});
      state.others(end + 1) = other;
      state = trustSource (state, problem, other, say);
    end
  end
end

function state = trustSource (state, problem, other, say)
  p = other.search.found.params;
  for attempt = 1:4
    before = rows (state.data.X);
    state = addRuns (state, problem, p, [], 'plan');
    if ~any (any (isfinite (state.data.Z(before + 1:end, :))))
      return                             % no budget, or the run failed
    end
    [odds, ~, values] = oddsOfShift (state.data, other, problem);
    if odds < 3
      say (sentence (['trusted.', other.source], values));
      return
    end
  end
  [state, text] = keepApart (state, problem);
  if ~isempty (text)
    say (text);
  end
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
%! % another wall: dropped after a further look, and said; a table of one's own, too
%! shifted = @(varargin) 1.2 * f (varargin{:});
%! [out, text] = trusted (data, problem, shifted);
%! assert (out.stage, repmat ({'plan'}, 4, 1));
%! assert (out.replicate, (1:4)');
%! assert (! isempty (strfind (text, 'stored runs of other cases are not used')));
%! data.stage(:) = {'import'};
%! [out, text] = trusted (data, problem, shifted);
%! assert (rows (out.X), 4);
%! assert (! isempty (strfind (text, 'runs.csv are not used')));
%!test
%! % one wrong run; no budget; too few runs to tell
%! once = @(P, E, r) (1 + 0.3 * (r == 1)) * f (P);
%! [out, text] = trusted (data, problem, once);
%! assert (rows (out.X), 12);
%! assert (text, '');
%! assert (trusted (data, problem, @(varargin) [NA, NA]), data);
%! assert (trusted (keepRows (data, 1:3), problem, f), keepRows (data, 1:3));

% SPDX-License-Identifier: GPL-3.0-only
