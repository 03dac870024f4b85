% REPORTDIAGNOSIS  Writes what a diagnosis has found, and tells it.
%
% CALL: [DIAGNOSIS, CONDITIONS] = reportDiagnosis (DIAGNOSIS, CASE, OPTIONS, SAY ...
%                                                  [, ISADVICE])
%
%   DIAGNOSIS   of diagnoseMatrices; nextFile, see writeNextMeasurement, is added
%   CASE        see newCase;  OPTIONS  see gapOptions
%   SAY, ISADVICE  see sayDiagnosis
%   CONDITIONS  see writeGapJson

function [diagnosis, conditions] = reportDiagnosis (diagnosis, Case, options, say, isAdvice)
  diagnosis.nextFile = writeNextMeasurement (diagnosis.next, Case, options);
  [~, conditions] = writeGapJson (diagnosis, Case);
  sayDiagnosis (Case, say, diagnosis.nextFile, nargin > 4 && isAdvice);
end

% SPDX-License-Identifier: GPL-3.0-only
