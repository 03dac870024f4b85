% SAYDIAGNOSIS  Tells a plant engineer what the diagnosis has found.
%
% CALL: sayDiagnosis (CASE, SAY [, NEXTFILE [, ISADVICE]])
%
%   CASE      see newCase: gap/gap.json of its folder is read
%   SAY       function handle that takes one line of text, or with it the class
%             of a verdict, see sayLine
%   NEXTFILE  table to be filled in for the next test ('')
%   ISADVICE  logical (false): the tables but that of the next tests were said before
%
% Tables first; the last lines are the verdict: where, what, how much of it is
% closed, what to do.

function sayDiagnosis (Case, say, nextFile, isAdvice)
  page = shownResult (Case);
  gap = page.sources.gap;
  if nargin < 4 || ~isAdvice
    sayFound (page, say);
  end
  sayTables (page, say, {'next'});
  if nargin > 2 && ~isempty (nextFile)
    cellfun (say, {['  Fill in what was measured: ', nextFile], ...
                   '  and start decalioc diagnose again: the test is part of the case.', ''});
  end
  found = {conditionTexts(gap).line};
  if numel (found) > 1
    sayTables (page, say, {'conditions'});
  end
  d = jsonAt (gap, {'demRuns'});
  if isfield (d, 'new')
    say (sprintf ('DEM runs: %d new, %d failed, %.1f core-minutes', d.new, d.failed, ...
                  d.coreSeconds / 60));
  end
  say (['Details: ', fullfile(Case.folder, 'gap', 'gap.json')]);
  v = page.verdict;
  % beside a calibration of an earlier input the diagnosis has an action of its own
  v.action = givenField (jsonAt (gap, {'verdict'}), 'action', v.action);
  sayPlain (v, found(1:end * (numel (found) > 1)), ...
            madeByText (gap, v.cause), say);
end

function sayFound (page, say)
  gap = page.sources.gap;
  condition = char (jsonAt (gap, {'reference', 'condition'}));
  if ~isempty (condition)
    cellfun (say, {'', ['CONDITION ', condition, ', compared with the reference']});
  end
  say ('');
  sayTables (page, say, {'where'});
  if ~isempty (page.sources.calibration)
    cellfun (say, {['  ', sentence('table.twoSets')], ''});
  end
  sayTables (page, say, {'causes', 'change'});
  if ~isempty (page.verdict.cause.closed)
    sayTables (page, say, {'howfar', 'beforeafter'});
  end
  text = levelText (gap);
  if ~isempty (text)
    cellfun (say, {['LEVEL: ', text], ''});
  end
end

% FOUND: a line a condition, where there are several.
function sayPlain (v, found, madeBy, say)
  cause = v.cause;
  say ('');
  if ~isempty (v.change)
    say (v.change);
  end
  say (cause.word, cause.class);
  unseen = listSentences ({'cause.unseen', plainName(cause.cannotSee)});
  where = 'MISSES  ';
  if ~isempty (cause.change)
    where = 'WHERE   ';
  end
  lines = {where, cause.where; 'CAUSE   ', cause.sentence; '        ', madeBy; ...
           'CLOSED  ', cause.closed; 'NEXT    ', v.action};
  lines = lines(~cellfun (@isempty, lines(:, 2)), :);
  cellfun (say, [strcat({'FOUND   '}, found), strcat(lines(:, 1), lines(:, 2))', ...
                 strcat({'        '}, [cause.notFollowed(:)', unseen, cause.untested(:)'])]);
end

% SPDX-License-Identifier: GPL-3.0-only
