% FAULTPROGRAM  Runs a plan of a case and writes its results: for fault tests.
%
% CALL: octave-cli faultProgram.m      in a case folder
%
% Writes answer.csv, all results with 17 digits, as its last act.
%
% See also: faultTrial

root = fileparts (fileparts (mfilename ('fullpath')));
addpath (fullfile (root, 'infrastructure'));
startToolbox (root, pwd ());
lock = lockCase (pwd ());
Case = loadCase (root, pwd ());
plan = GenerateExperPlan (Case.limits, Case.options.numOfSam, '', 1);
Z = evaluateDEM (plan, Case, 1, 'plan', newProgress ('plan', @disp));
writeMatrix ('answer.csv', Z);

% SPDX-License-Identifier: GPL-3.0-only
