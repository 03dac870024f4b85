% REPORTCALIBRATION  Says what a calibration has found.
%
% CALL: reportCalibration (C, CASE, SAY)
%
%   C     see newCalibration
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%
% See also: newCalibration, DEcalioc

function reportCalibration (c, Case, say)
  say ('');
  if c.converged
    say (['CALIBRATED: ', c.reason]);
  else
    say (['NOT CALIBRATED: ', c.reason]);
  end
  say ('');
  sayTargets (c, Case, say);
  say ('');
  sayParameters (c, Case, say);
  say ('');
  d = c.demRuns;
  say (sprintf (['DEM runs: %d plan, %d infill, %d verification; %d failed, ' ...
                 '%d taken from the store; %.1f core-minutes'], d.plan, ...
                d.infill, d.verify, d.failed, d.reused, c.coreSeconds / 60));
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
  for t = 1:numel (Case.targets)
    T = Case.targets(t);
    say (sprintf ('  %-28s %11.5g %11.5g %9.2f %9.2f %11.2g', ...
                  [T.name, repmat(' (held out)', 1, ...
                                  strcmp (T.role, 'holdout'))], T.value, ...
                  c.results(t), 100 * c.residual(t), 100 * T.tol, c.runSd(t)));
  end
  say (sprintf ('  DEM: mean of %d runs with different packings', c.runs));
end

function sayParameters (c, Case, say)
  say (sprintf ('  %-24s %11s %11s %11s   %s', 'parameter', 'value', ...
                'lower', 'upper', '90 % of the sets that fit'));
  for j = 1:numel (Case.names)
    say (sprintf ('  %-24s %11.5g %11.5g %11.5g   %.4g to %.4g', ...
                  Case.names{j}, c.params(j), Case.limits(1, j), ...
                  Case.limits(2, j), c.interval90(1, j), c.interval90(2, j)));
  end
  if ~ isempty (c.atLimit)
    say (sprintf ('  WARNING: at its limit: %s; is the limit right?', ...
                  strjoin (c.atLimit(:)', ', ')));
  end
  if ~ isempty (c.notIdentified)
    say (sprintf ('  WARNING: not fixed by these targets: %s', ...
                  strjoin (c.notIdentified(:)', ', ')));
  end
end
