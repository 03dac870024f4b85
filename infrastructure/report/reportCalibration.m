% REPORTCALIBRATION  Says what a calibration has found.
%
% CALL: reportCalibration (C, CASE, SAY)
%
%   C     see newCalibration, with its field verdict (decideCase)
%   CASE  see newCase
%   SAY   function handle that takes one line of text

function reportCalibration (c, Case, say)
  tell = @(varargin) say (sprintf (varargin{:}));
  say ('');
  say ([repmat('NOT ', 1, ~c.converged), 'CALIBRATED: ', c.reason]);
  if ~isempty (c.verdict.gap)
    say (['  ', c.verdict.gap]);
  end
  sayVerdict (c.verdict, say);
  say ('');
  sayTargets (c, Case, tell);
  say ('');
  sayParameters (c, Case, tell);
  say ('');
  saySensitivity (c, Case, tell);
  sayUnknown (c, Case, tell);
  if ~isempty (c.untested)
    say (['  the surrogates expect more of a set that was not run: ', ...
          namedValues(Case.names, c.untested, '%.4g')]);
  end
  for k = 1:numel (c.warnings)
    say (['  WARNING: ', c.warnings{k}]);
  end
  say ('');
  if ~isempty (c.levels)
    sayLevels (c, Case, tell);
    say ('');
  end
  d = c.demRuns;
  tell (['DEM runs: %d plan, %d infill, %d verification; ' ...
         '%d without a result, also with another seed; %d taken ' ...
         'from the store; %.1f core-minutes'], d.plan, d.infill, d.verify, ...
        d.failed, d.reused, c.coreSeconds / 60);
  store = fullfile (Case.store, 'optim');
  tell ('Runs: %s  Results: %s', store, ...
        fullfile (Case.folder, 'results', 'calibration.json'));
  names = getOptimFolder (c.params, Case);
  for k = find (cellfun (@ischar, names))
    tell ('A run with these parameters: %s', ...
          fullfile (store, Case.models(k).name, names{k}));
  end
end

function sayTargets (c, Case, tell)
  tell ('  %-28s %11s %11s %11s %9s %9s %11s', 'target', 'measured', 'DEM', ...
        'all runs', 'resid (%)', 'tol (%)', 'one run +-');
  curves = curveSummary (Case, c.residual);
  for t = setdiff (1:numel (Case.targets), [curves.own])
    own = struct ('state', c.state{t}, 'met', c.met(t), 'runs', c.runs);
    sayTarget (Case.targets(t), [c.results(t), c.estimate(t)], ...
               c.residual(t), c.noiseSd(t), own, tell);
  end
  for one = curves
    tell (['  %-28s %d points, root mean square deviation %.2f of ' ...
           'the tolerance'], one.name, numel (one.own), one.share);
  end
  if c.runs > 1
    tell (['  DEM: mean of %d runs with different packings; all runs: ' ...
           'expected mean, as all runs of all sets tell it'], c.runs);
  elseif c.runs > 0
    tell (['  DEM: one run; all runs: expected mean, as all runs of all sets ' ...
           'tell it']);
  else
    tell (['  No DEM run was made with this set: ', ...
           'the values are those of the surrogates']);
  end
  for k = 1:numel (c.holdout)
    h = c.holdout(k);
    if isnan (h.inside)
      tell (['  not measured: %s predicted %.5g, 90 %% interval ' ...
             '%.5g to %.5g'], h.name, h.result, h.interval90);
    else
      tell (['  held out: %s measured %.5g, predicted %.5g, 90 %% ' ...
             'interval %.5g to %.5g%s'], h.name, h.target, h.result, ...
            h.interval90, repmat (', OUTSIDE', 1, ~h.inside));
    end
  end
end

function sayTarget (T, results, residual, noiseSd, own, tell)
  words = struct ('calibrate', '', 'holdout', ' (held out)', ...
                  'unmeasured', ' (not measured)');
  name = [T.name, words.(T.role)];
  factor = 100 - 99 * T.isAbsolute;
  note = repmat (' (absolute)', 1, T.isAbsolute);
  if strcmp (T.role, 'calibrate') && strcmp (own.state, 'open') && own.runs > 0
    note = [note, ' open'];
  elseif strcmp (T.role, 'calibrate') && ~own.met
    note = [note, ' missed'];
  end
  tell ('  %-28s %11.5g %11.5g %11.5g %9.2f %9.2f %11.2g%s', name, T.value, ...
        results, factor * residual, factor * T.tol, noiseSd, note);
end

function sayParameters (c, Case, tell)
  tell ('  %-24s %11s %11s %11s   %s', 'parameter', 'value', 'lower', ...
        'upper', '90 % of the sets that fit');
  for j = 1:numel (Case.names)
    range = sprintf ('%.4g to %.4g', c.interval90(:, j));
    if any (isnan (c.interval90(:, j)))
      range = 'not printed';
    end
    tell ('  %-24s %11.5g %11.5g %11.5g   %s', Case.names{j}, c.params(j), ...
          Case.limits(1:2, j), range);
  end
  if ~isempty (c.intervalNote)
    tell ('  The intervals are %s.', c.intervalNote);
  end
end

function saySensitivity (c, Case, tell)
  tell (['  share of each response''s variance over the box that a ', ...
         'parameter makes']);
  shown = shownTargets (Case);
  tell ('  %-24s%s', '', sprintf (' %20.20s', Case.targets(shown).name));
  for j = 1:numel (Case.names)
    tell ('  %-24s%s', Case.names{j}, ...
          sprintf (' %20.2f', c.sensitivity(j, shown)));
  end
end

function sayUnknown (c, Case, tell)
  weak = c.identifiability;
  for k = 1:numel (weak.text)
    tell ('  not fixed by these targets: %s', weak.text{k});
  end
  [i, j] = find (triu (abs (c.correlation) > 0.7, 1));
  for k = 1:numel (i)
    tell ('  only together: %s and %s (correlation %.2f)', Case.names{i(k)}, ...
          Case.names{j(k)}, c.correlation(i(k), j(k)));
  end
  if ~isempty (weak.text) && ~isempty (weak.next)
    tell ('  what would fix most: %s, %s', weak.next(1).kind, ...
          weak.next(1).name);
  end
end

% What each level has told and cost.
function sayLevels (c, Case, tell)
  tell ('  %-28s %5s %12s   %s', 'level', 'runs', 'core-seconds', ...
        'what it does to the responses at the set');
  for k = 1:numel (c.levels)
    level = c.levels(k);
    what = 'counts';
    if k < numel (c.levels)
      what = levelLine (level, Case.targets);
    end
    tell ('  %-28s %5d %12.3g   %s', ...
          namedValues ({Case.coarse.variable}, level.value), level.runs, ...
          level.seconds, what);
  end
end

%!test
%! % one run is off by more than the tolerance, the mean of all runs is not
%! s = verdictCase ()(1);
%! s.c.targets(1).result = 7.21;
%! s.c.targets(1).residual = 0.03;
%! s.c.targets(1).estimate = 7.1;
%! [s.c.targets.state] = deal ('met');
%! s.c.targets(1).state = 'open';
%! raw = standInCase (tempname ());
%! text = verdictConsole (s, newCase (raw));
%! assert (! isempty (strfind (text, 'all runs together 7.1 N, measured 7 N')));
%! assert (! isempty (regexp (text, 'open: .*says? missed, all runs together')));
%! assert (! isempty (regexp (text, ' 7.21 +7.1 .* open')), text);
