% REPORTCALIBRATION  Says what a calibration has found.
%
% CALL: reportCalibration (C, CASE, SAY)
%
%   C     see newCalibration, with its field verdict (decideCase)
%   CASE  see newCase
%   SAY   function handle that takes one line of text

function reportCalibration (c, Case, say)
  say ('');
  if c.converged
    say (['CALIBRATED: ', c.reason]);
  else
    say (['NOT CALIBRATED: ', c.reason]);
  end
  if ~isempty (c.verdict.gap)
    say (['  ', c.verdict.gap]);
  end
  sayVerdict (c.verdict, say);
  say ('');
  sayTargets (c, Case, say);
  say ('');
  sayParameters (c, Case, say);
  say ('');
  saySensitivity (c, Case, say);
  sayUnknown (c, Case, say);
  if ~isempty (c.untested)
    say (['  the surrogates expect more of a set that was not run: ', ...
          namedValues(Case.names, c.untested, '%.4g')]);
  end
  for k = 1:numel (c.warnings)
    say (['  WARNING: ', c.warnings{k}]);
  end
  say ('');
  sayLevels (c, Case, say);
  d = c.demRuns;
  say (sprintf (['DEM runs: %d plan, %d infill, %d verification; ' ...
                 '%d without a result, also with another seed; %d taken ' ...
                 'from the store; %.1f core-minutes'], ...
                d.plan, d.infill, d.verify, d.failed, d.reused, ...
                c.coreSeconds / 60));
  say (sprintf ('Runs: %s  Results: %s', ...
                fullfile (Case.store, 'optim'), ...
                fullfile (Case.folder, 'results', 'calibration.json')));
  names = getOptimFolder (c.params, Case);
  for k = 1:numel (names)
    if ischar (names{k})
      say (sprintf ('A run with these parameters: %s', ...
                    fullfile (Case.store, 'optim', Case.models(k).name, ...
                              names{k})));
    end
  end
end

function sayTargets (c, Case, say)
  say (sprintf ('  %-28s %11s %11s %9s %9s %11s', 'target', 'measured', ...
                'DEM', 'resid (%)', 'tol (%)', 'one run +-'));
  curves = curveSummary (Case, c.residual);
  for t = setdiff (1:numel (Case.targets), [curves.own])
    sayTarget (Case.targets(t), c.results(t), c.residual(t), c.noiseSd(t), ...
               c.met(t), say);
  end
  for k = 1:numel (curves)
    say (sprintf (['  %-28s %d points, root mean square deviation %.2f of ' ...
                   'the tolerance'], curves(k).name, ...
                  numel (curves(k).own), curves(k).share));
  end
  if c.runs > 0
    text = 'one run';
    if c.runs > 1
      text = sprintf ('mean of %d runs with different packings', c.runs);
    end
    say (['  DEM: ', text, '; simulated (above): as all runs tell it']);
  else
    say (['  No DEM run was made with this set: ', ...
          'the values are those of the surrogates']);
  end
  for k = 1:numel (c.holdout)
    h = c.holdout(k);
    if isnan (h.inside)
      say (sprintf (['  not measured: %s predicted %.5g, 90 %% interval ' ...
                     '%.5g to %.5g'], h.name, h.result, h.interval90));
      continue
    end
    outside = repmat (', OUTSIDE', 1, ~h.inside);
    say (sprintf (['  held out: %s measured %.5g, predicted %.5g, 90 %% ' ...
                   'interval %.5g to %.5g%s'], h.name, h.target, h.result, ...
                  h.interval90, outside));
  end
end

function sayTarget (T, result, residual, noiseSd, isMet, say)
  name = T.name;
  if ~strcmp (T.role, 'calibrate')
    words = struct ('holdout', ' (held out)', 'unmeasured', ' (not measured)');
    name = [name, words.(T.role)];
  end
  factor = 100;
  note = '';
  if T.isAbsolute
    factor = 1;
    note = ' (absolute)';
  end
  if strcmp (T.role, 'calibrate') && ~isMet
    note = [note, ' missed'];
  elseif strcmp (T.role, 'calibrate') && abs (residual) > T.tol
    note = [note, ' met, as all runs tell it'];
  end
  say (sprintf ('  %-28s %11.5g %11.5g %9.2f %9.2f %11.2g%s', name, T.value, ...
                result, factor * residual, factor * T.tol, noiseSd, note));
end

function sayParameters (c, Case, say)
  say (sprintf ('  %-24s %11s %11s %11s   %s', 'parameter', 'value', ...
                'lower', 'upper', '90 % of the sets that fit'));
  for j = 1:numel (Case.names)
    say (sprintf ('  %-24s %11.5g %11.5g %11.5g   %.4g to %.4g', ...
                  Case.names{j}, c.params(j), Case.limits(1, j), ...
                  Case.limits(2, j), c.interval90(1, j), c.interval90(2, j)));
  end
end

function saySensitivity (c, Case, say)
  say (['  share of each response''s variance over the box that a ', ...
        'parameter makes']);
  shown = shownTargets (Case);
  say (sprintf ('  %-24s%s', '', sprintf (' %20.20s', ...
                                          Case.targets(shown).name)));
  for j = 1:numel (Case.names)
    say (sprintf ('  %-24s%s', Case.names{j}, ...
                  sprintf (' %20.2f', c.sensitivity(j, shown))));
  end
end

function sayUnknown (c, Case, say)
  weak = c.identifiability;
  for k = 1:numel (weak.text)
    say (['  not fixed by these targets: ', weak.text{k}]);
  end
  [i, j] = find (triu (abs (c.correlation) > 0.7, 1));
  for k = 1:numel (i)
    say (sprintf ('  only together: %s and %s (correlation %.2f)', ...
                  Case.names{i(k)}, Case.names{j(k)}, ...
                  c.correlation(i(k), j(k))));
  end
  if ~isempty (weak.text) && ~isempty (weak.next)
    say (sprintf ('  what would fix most: %s, %s', weak.next(1).kind, ...
                  weak.next(1).name));
  end
end

% What each level has told and cost.
function sayLevels (c, Case, say)
  if isempty (c.levels)
    return
  end
  say (sprintf ('  %-28s %5s %12s   %s', 'level', 'runs', 'core-seconds', ...
                'what it does to the responses at the set'));
  names = {Case.coarse.variable};
  for k = 1:numel (c.levels)
    own = c.levels(k);
    text = namedValues (names, own.value);
    what = 'counts';
    if k < numel (c.levels)
      what = levelLine (own, Case.targets);
    end
    say (sprintf ('  %-28s %5d %12.3g   %s', text, own.runs, own.seconds, ...
                  what));
  end
  say ('');
end

%!test
%! [~, text] = situationPage ('met, held out outside');
%! assert (! isempty (strfind (text, 'CALIBRATED: all targets met')), text);
%! assert (! isempty (strfind (text, ...
%!         'held out: difference measured 5, predicted 1')));
%! assert (! isempty (strfind (text, 'OUTSIDE')), text);
%! assert (! isempty (strfind (text, '8 plan, 2 infill, 4 verification')));
%!test
%! [~, text] = situationPage ('missed, no gap');
%! assert (! isempty (strfind (text, 'NOT CALIBRATED: the mean')), text);
%! assert (! isempty (strfind (text, '20.00      1.00        0.01 missed')));
%!test
%! % one run is off by more than the tolerance, the mean of all runs is not
%! s = verdictCase ()(1);
%! s.c.targets(1).result = 7.21;
%! s.c.targets(1).residual = 0.03;
%! s.c.targets(1).estimate = 7.1;
%! raw = standInCase (tempname ());
%! text = verdictConsole (s, newCase (raw));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! assert (! isempty (strfind (text, 'met, as all runs tell it')), text);
%! assert (! isempty (strfind (text, 'simulated 7.1 N, measured 7 N')), text);
