% SAYCALIBRATION  Says what a calibration has found, its verdict last.
%
% CALL: sayCalibration (CASE, SAY)
%
%   CASE  see newCase: the files of its results are read
%   SAY   function handle that takes one line of text, or with it the class of a
%         verdict, see sayLine

function sayCalibration (Case, say)
  page = shownResult (Case);
  c = page.sources.calibration;
  say ('');
  sayTables (page, say, {'parameters', 'sensitivity', 'levels', 'targets'});
  for k = 1:numel (c.holdout)
    h = jsonAt (c.holdout, {k});
    say (['  ', heldText(h, targetCell (page, h))]);
  end
  sayUnknown (page, say);
  sayNotes (namesIn (c, 'warnings'), Case.folder, say);
  d = c.demRuns;
  say (sprintf (['DEM runs: %d plan, %d infill, %d verification; %d without a result, also ' ...
                 'with another seed; %d made earlier; %.1f core-minutes'], d.plan, ...
                d.infill, d.verify, d.failed, d.reused, c.coreSeconds / 60));
  say (['Runs: ', runPlace(Case), '  Results: ', ...
        fullfile(Case.folder, 'results', 'calibration.json')]);
  names = getOptimFolder (cellfun (@(n) c.params.(n), Case.names), Case);
  for k = find (cellfun (@ischar, names))
    say (['A run with these parameters: ', runPlace(Case, Case.models(k).name, names{k})]);
  end
  say ('');
  v = page.verdict;
  misled = char (jsonAt (c, {'sources', 'misled'}));
  if ~isempty (misled)
    say (misled);
  end
  say ([repmat('NOT ', 1, ~c.converged), 'CALIBRATED: ', c.reason], v.class);
  if ~isempty (v.gap)
    say (['  ', v.gap]);
  end
  sayVerdict (v, say);
end

% In the unit of SHOWN, see targetCell.
function text = heldText (h, shown)
  for name = {'result', 'target', 'interval90'}
    h.(name{1}) = h.(name{1}) * givenField (shown, 'factor', 1);
  end
  unit = regexprep (regexprep (shown.unit, '^-$', ''), '^.', ' $0');
  if isempty (h.result)
    text = sentence ('notFor.unjudged', {h.name});
  elseif isempty (h.inside)
    text = sprintf ('not measured: %s predicted %.4g%s, 90 %% interval %.4g to %.4g', ...
                    h.name, h.result, unit, h.interval90);
  else
    text = sprintf (['not fitted: %s measured %.4g%s, predicted %.4g, 90 %% interval ' ...
                     '%.4g to %.4g%s'], h.name, h.target, unit, h.result, h.interval90, ...
                    repmat (', OUTSIDE', 1, ~h.inside));
    if isequal (givenField (h, 'leftOpen', false), true)
      text = [text, ': ', sentence('heldOut.open')];
    end
  end
end

function sayUnknown (page, say)
  names = page.Case.names;
  c = page.sources.calibration;
  R = abs (c.correlation);
  if isequal (size (R), numel (names) * [1, 1])
    [i, j] = find (triu (R > 0.7, 1));
    for k = 1:numel (i)
      say (sprintf ('  only together: %s and %s (correlation %.2f)', names{i(k)}, ...
                    names{j(k)}, c.correlation(i(k), j(k))));
    end
  end
  untested = jsonAt (c, {'untested'});
  if isstruct (untested)
    say (['  the fitted surfaces expect more of values that were not run: ', ...
          namedValues(names, cellfun (@(n) untested.(n), names), '%.4g')]);
  end
end

%!test
%! % one run is off by more than the tolerance, the mean of all runs is not; the
%! % verdict comes last
%! s = verdictCase ()(1);
%! s.c.targets(1).result = 7.21;
%! s.c.targets(1).residual = 0.03;
%! s.c.targets(1).estimate = 7.1;
%! [s.c.targets.state] = deal ('met');
%! s.c.targets(1).state = 'open';
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'sum', 'product'}, {'difference'}};
%! text = verdictConsole (s, newCase (raw));
%! assert (! isempty (strfind (text, 'expected from all runs 7.1 N, measured 7 N')));
%! assert (! isempty (regexp (text, 'open: .*says? missed, all runs together')));
%! assert (! isempty (regexp (text, ' 7.21 +7.1 .* open')), text);
%! assert (regexp (text, 'DEM runs:') < regexp (text, '\nCALIBRATED:'));

% SPDX-License-Identifier: GPL-3.0-only
