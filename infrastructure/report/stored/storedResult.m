% STOREDRESULT  The results in the files of a case, and whether they still hold.
%
% CALL: [S, V] = storedResult (CASE)
%
%   CASE  see newCase
%   S     scalar struct: calibration, gap (decoded results/calibration.json and
%         gap/gap.json; [] where there is none, or one of 0.9.0 or earlier), changed
%         (1 x n cell of words: what has changed since the result was made, see
%         changedInput, and its runs, where some were forgotten or are gone; of the
%         calibration, where there is none of the diagnosis), gapChanged (of the
%         diagnosis), lastRuns (1 x M, number of the last run folder of each model
%         that one of them knows; Inf: none does)
%   V     function handle: V () is the verdict on them, see decideStored
%
% See also: decideStored

function [s, v] = storedResult (Case)
  files = {fullfile('results', 'calibration.json'), ...
           fullfile('gap', 'gap.json')};
  found = cellfun (@(f) ofToday (readJsonFile (fullfile (Case.folder, f))), files, ...
                   'UniformOutput', false);
  s = struct ('calibration', found(1), 'gap', found(2));
  now = resultInput (Case);
  changed = @(result) [changedInput(result, now), lostRuns(result, Case)];
  s.gapChanged = changed (s.gap);
  s.changed = s.gapChanged;
  if ~isempty (s.calibration)
    s.changed = changed (s.calibration);
  end
  s.lastRuns = lastRuns (found, {Case.models.name});
  v = @() decideStored (s);
end

% Until 0.9.0 a result did not say of which input it was, and had other fields.
function result = ofToday (result)
  input = jsonAt (result, {'input'});
  if isfield (input, 'models') && ~isfield (input, 'digest')
    result = [];
  end
end

function last = lastRuns (results, names)
  last = -Inf (1, numel (names));
  for result = results
    for model = jsonList (result{1}, {'input', 'models'})
      k = strcmp (givenField (model{1}, 'name', ''), names);
      last(k) = max (last(k), givenField (model{1}, 'lastRun', -Inf));
    end
  end
  last(isinf (last)) = Inf;
end

function word = lostRuns (result, Case)
  isLess = @(m) countFinished (m, Case) < givenField (m, 'runs', 0);
  models = jsonList (result, {'input', 'models'});
  word = repmat ({'its runs'}, 1, any (cellfun (isLess, models)));
end

%!test
%! Case = readyCase ();
%! s = storedResult (Case);
%! assert ({s.calibration, s.gap, s.changed}, {[], [], cell(1, 0)});
%! assert (s.lastRuns, [Inf, Inf]);
%! put = @(name, value) writeAtomic (fullfile (Case.folder, name), ...
%!                                   jsonencode (value));
%! mkdir (fullfile (Case.folder, 'results'));
%! mkdir (fullfile (Case.folder, 'gap'));
%! evaluateDEM ([1, 2; 3, 4], Case);
%! put ('results/calibration.json', struct ('input', resultInput (Case)));
%! s = storedResult (Case);
%! assert ({s.changed, s.lastRuns}, {cell(1, 0), [2, 2]});
%! % a later run and one that it does not know change nothing; one of its own does
%! evaluateDEM ([9, 9], Case);
%! forgetRuns (Case.store, 'First', [3, 3], false);
%! assert (storedResult (Case).changed, cell (1, 0));
%! forgetRuns (Case.store, 'First', [1, 1], false);
%! assert (storedResult (Case).changed, {'its runs'});
%! forgetRuns (Case.store, 'First', [1, 1], true);
%! assert (storedResult (Case).changed, cell (1, 0));
%! evaluateDEM ([5, 6], Case);
%! was = struct ('input', resultInput (Case), 'which', struct ());
%! was.input.digest.settings = 'x';
%! put ('gap/gap.json', was);
%! Case.limits(1) = -1;
%! s = storedResult (Case);
%! assert (s.changed, {'parameters or limits'});
%! assert (s.gapChanged, {'parameters or limits', 'settings'});
%! assert (s.lastRuns, [4, 4]);
%! % of 0.9.0
%! put ('results/calibration.json', ...
%!      struct ('params', struct ('a', 1), 'reason', 'met', ...
%!              'input', struct ('models', struct ('name', 'First', 'key', 'x'))));
%! assert (isempty (storedResult (Case).calibration));

% SPDX-License-Identifier: GPL-3.0-only
