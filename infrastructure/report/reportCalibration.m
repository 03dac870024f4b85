% REPORTCALIBRATION  Writes what a calibration has found, and says it.
%
% CALL: C = reportCalibration (C, CASE, SAY)
%
%   C     see newCalibration; verdict, see decideCase, is added
%   CASE  see newCase
%   SAY   see sayCalibration
%
% See also: writeCalibrationJson, sayCalibration, reportPage

function c = reportCalibration (c, Case, say)
  Case.hashes = hashModels (Case);      % asked for several times
  c.verdict = writeCalibrationJson (c, Case);
  sayCalibration (Case, say);
  reportPage (Case, say);
end

% SPDX-License-Identifier: GPL-3.0-only
