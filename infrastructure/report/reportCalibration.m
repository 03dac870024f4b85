% REPORTCALIBRATION  Writes what a calibration has found, and says it.
%
% CALL: C = reportCalibration (C, CASE, SAY)
%
%   C     see newCalibration; verdict, see decideCase, is added, and isMixed: the model
%         was edited while it ran, so that runs of two models are in it. It is then a
%         result of an earlier input
%   CASE  see newCase
%   SAY   see sayCalibration
%
% See also: writeCalibrationJson, sayCalibration, reportPage

function c = reportCalibration (c, Case, say)
  Case.hashes = hashModels (Case);      % asked for several times
  c.isMixed = isMixed (c.data, Case);
  if c.isMixed
    c.exitStatus = 2;
    c.reason = ['The model was edited while it ran: runs of both are in this. ', c.reason];
  end
  c.verdict = writeCalibrationJson (c, Case);
  sayCalibration (Case, say);
  reportPage (Case, say);
end

% Fewer runs of the model as it is now than rows that rest on runs of this case. In a
% shared store they may be those of another one.
function yes = isMixed (data, Case)
  yes = false;
  runs = runsOfCase (Case);
  good = runs([runs.isCurrent] & strcmp ({runs.state}, 'ok'));
  isOwn = ~ismember (data.stage, {'import', 'library'}) & strcmp (Case.store, Case.folder);
  for k = 1:numel (Case.models)
    Z = data.Z(:, [Case.targets.model] == k);
    isRun = isOwn(:) & any (isfinite (Z), 2);
    Z(~isfinite (Z)) = 0;
    made = [data.X, data.E, Z];
    yes = yes || sum ([good.model] == k) < rows (unique (made(isRun, :), 'rows'));
  end
end

%!test
%! % runs of one model; it was edited after them; so was how they are read
%! [problem, state] = smallCalibration ();
%! state.final = mergeFields (confirmSet (state, problem), struct ('untested', []));
%! raw = standInCase (tempname ());
%! [raw.Input.model, raw.Input.cpu] = deal ({'First'}, 1);
%! [raw.optim.targetVal, raw.optim.tolRes] = deal ({[4, 2]}, 0.02);
%! Case = newCase (raw);
%! c = newCalibration (state, problem, Case);
%! c.history = struct ('params', [5, 6], 'residual', [0.1; 0.2], 'ofRuns', [NaN; NaN]);
%! P = [1, 2; 3, 4];
%! c.data = addRows (newData (2, 2), P, evaluateDEM (P, Case), [1; 1], 'plan');
%! evalc ('r = reportCalibration (c, Case, @(line, varargin) disp (line));');
%! assert (~r.isMixed && ~strncmp (r.verdict.word, 'Result', 6), r.verdict.word);
%! for name = {'OctaveFuns/note.m', 'note'}
%!   writeAtomic (fullfile (Case.models.folder, name{1}), '%');
%!   evalc ('r = reportCalibration (c, Case, @(line, varargin) disp (line));');
%!   assert ({r.isMixed, r.exitStatus}, {true, 2});
%!   assert (r.verdict.word, 'Result of an earlier input (model changed)');
%!   assert (strncmp (r.reason, 'The model was edited', 20));
%!   assert (storedResult (Case).changed, {'model'});
%! end

% SPDX-License-Identifier: GPL-3.0-only
