% SAYDIAGNOSIS  Tells a plant engineer what the diagnosis has found.
%
% CALL: sayDiagnosis (CASE, SAY [, NEXTFILE])
%
%   CASE      see newCase: gap/gap.json of its folder is read
%   SAY       function handle that takes one line of text, or with it the class
%             of a verdict, see sayLine
%   NEXTFILE  table to be filled in for the next test ('')
%
% Tables first; the last lines are the verdict: where, what, how much of it is
% closed, what to do.

function sayDiagnosis (Case, say, nextFile)
  page = shownResult (Case);
  gap = page.sources.gap;
  v = page.verdict;
  condition = jsonAt (gap, {'reference', 'condition'});
  if ~isempty (condition)
    say ('');
    say (['CONDITION ', condition, ' beside the reference']);
  end
  say ('');
  sayTables (page, say, {'where'});
  if ~isempty (page.sources.calibration)
    say (['  ', sentence('table.twoSets')]);
    say ('');
  end
  sayTables (page, say, {'causes', 'change'});
  if ~isempty (v.cause.closed)
    sayTables (page, say, {'howfar', 'beforeafter'});
  end
  if ~isempty (jsonAt (gap, {'level'}))
    say (['LEVEL: ', levelText(gap.level)]);
    say ('');
  end
  sayTables (page, say, {'next'});
  if nargin > 2 && ~isempty (nextFile)
    say (['  Fill in what was measured: ', nextFile]);
    say ('  and start decalioc diagnose again: the test is part of the case.');
    say ('');
  end
  if numel (jsonAt (gap, {'reference', 'conditions'})) > 1
    sayTables (page, say, {'conditions'});
  end
  d = jsonAt (gap, {'demRuns'});
  if isfield (d, 'new')
    say (sprintf ('DEM runs: %d new, %d failed, %.1f core-minutes', d.new, d.failed, ...
                  d.coreSeconds / 60));
  end
  say (['Details: ', fullfile(Case.folder, 'gap', 'gap.json')]);
  % beside a calibration of an earlier input the diagnosis has an action of its own
  own = jsonAt (gap, {'verdict', 'action'});
  if ischar (own) && ~isempty (own)
    v.action = own;
  end
  found = {conditionTexts(gap).line};
  sayPlain (v, found(1:end * (numel (found) > 1)), ...
            madeByText (jsonAt (gap, {'which', 'cause'})), say);
end

% FOUND: a line a condition, where there are several.
function sayPlain (v, found, madeBy, say)
  cause = v.cause;
  say ('');
  say (upperFirst (cause.word), cause.class);
  cellfun (@(line) say (['FOUND   ', line]), found);
  lines = {'MISSES  ', cause.where; 'CAUSE   ', cause.sentence; '        ', madeBy; ...
           'CLOSED  ', cause.closed; 'NEXT    ', v.action; ...
           '        ', sentence('cause.unseen', struct ('names', {plainName(cause.cannotSee)}))};
  lines{6, 2} = lines{6, 2}(1:end * ~isempty (cause.cannotSee));
  for line = lines(~cellfun (@isempty, lines(:, 2)), :)'
    say ([line{:}]);
  end
  cellfun (@(text) say (['        ', text]), cause.untested);
end

function text = upperFirst (text)
  text = [upper(text(1)), text(2:end)];
end
