% SHOWNRESULT  What the report says of a case, from the files of its results.
%
% CALL: PAGE = shownResult (CASE [, ISBEGUN])
%
%   CASE     see newCase
%   ISBEGUN  logical (true): see decideCase
%   PAGE     scalar struct:
%     Case        CASE, with its candidate effects where there is a gap/
%     sources     struct of decoded files, [] where there is none: calibration ([],
%                 too, where it has other parameters than CASE), progress, gap (JSON)
%     targets     1 x T struct array of texts, '' where it is not known: label
%                 (words of results.csv), unit
%     params      1 x d struct array, the same of data.head
%     verdict     see decideCase
%     isChange    logical: the diagnosis is one of a change;  showsEffect
%                 beside the targets stands what the effect makes of them
%
% Console, page and tables are made of it, so they say the same.

function page = shownResult (Case, isBegun)
  results = fullfile (Case.folder, 'results');
  [s, stored] = sourcesOf (Case, results);
  if ~isempty (s.gap) && isempty (Case.effects)
    try
      Case = withEffects (Case);
    catch
      % the page is shown without
    end
  end
  info = targetInfo (Case);
  [labels, units] = paramLabels (Case);
  page = struct ('Case', Case, 'sources', s);
  page.targets = struct ('label', {info.text}, ...
                         'unit', regexprep ({info.unit}, '^-$', ''));
  page.params = struct ('label', labels(:)', 'unit', units(:)');
  page.verdict = decideStored (stored, nargin < 2 || isBegun);
  page.isChange = ~isempty (jsonAt (s.gap, {'reference'}));
  % beside the reference that was calibrated the effect of a change is no fit
  isOther = page.isChange && ~isempty (s.calibration);
  page.showsEffect = ~isOther && ...
                     ~isempty (jsonAt (page.verdict, {'cause', 'closed'}));
end

% No calibration while one is under way, or was broken off; no diagnosis of an
% earlier input beside a calibration of today's.
function [s, stored] = sourcesOf (Case, results)
  stored = storedResult (Case);
  s.progress = readJsonFile (fullfile (results, 'progress.json'));
  if ~isempty (s.progress)
    stored.calibration = [];
  end
  if isempty (stored.calibration)
    stored.changed = stored.gapChanged;
  end
  [s.calibration, s.gap] = deal (stored.calibration, stored.gap);
  if isempty (stored.changed) && ~isempty (stored.gapChanged)
    s.gap = [];
  end
  params = jsonAt (s.calibration, {'params'});
  if isstruct (params) && ~isequal (fieldnames (params)(:), Case.names(:))
    s.calibration = [];                  % the verdict says that they have changed
  end
end

%!test
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'sum', 'product'}, {'difference'}};
%! list = verdictCase ();
%! verdictCase (raw.folder, list(strcmp ({list.name}, 'missed, named')));
%! page = shownResult (newCase (raw));
%! assert (page.verdict.class, 'bad');
%! assert (numel (page.targets), 3);
%! assert (page.showsEffect && ~page.isChange);
%! % of other parameters the verdict is told, their values are not shown
%! other = raw;
%! other.assign = {'b', 'a'};
%! page = shownResult (newCase (other));
%! assert (isempty (page.sources.calibration));
%! % one that is broken off shows no older result
%! writeAtomic (fullfile (raw.folder, 'results', 'progress.json'), '{"a": 1}');
%! page = shownResult (newCase (raw));
%! assert (isempty (page.sources.calibration));

% SPDX-License-Identifier: GPL-3.0-only
