% VERDICTCONSOLE  What calibration and diagnosis print of a stored situation.
%
% CALL: TEXT = verdictConsole (SITUATION, CASE)
%
%   SITUATION  one of verdictCase ()
%   CASE       newCase of standInCase; the files of SITUATION are written there
%   TEXT       all lines of sayCalibration and sayDiagnosis, as far as the
%              situation has a calibration and a diagnosis
%
% See also: verdictCase, sayCalibration, sayDiagnosis

function text = verdictConsole (situation, Case)
  verdictCase (Case.folder, situation);
  say = @(line, varargin) printf ("%s\n", line);
  text = '';
  if ~isempty (situation.c)
    [Case.targets.role] = situation.c.targets.role;
    text = evalc ('sayCalibration (Case, say)');
  end
  if ~isempty (situation.gap)
    text = [text, evalc('sayDiagnosis (Case, say)')];
  end
end

% SPDX-License-Identifier: GPL-3.0-only
