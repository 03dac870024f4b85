% TWINSDIAGNOSE  Diagnoses every twin from its observables alone.
%
% CALL: VERDICTS = twinsDiagnose (LABS, TWINS)
%
%   LABS, TWINS  of foreignTwins, twinsDraw; of TWINS only lab, removed
%                (the list is shorter then) and y are looked at
%   VERDICTS     1 x n struct: kind, effects, top, named (cellstr), P (1 x (K +
%                3): null, each effect, pairs, unlisted), interval (K x 3:
%                strength of each effect, median and 90 %), gateP, seconds,
%                total (1 x K, P of the effect and its pairs), lookAlike (the
%                verdict says: or something that looks like it), sameKind (it
%                says: one kind of cause, see judgeCase)
%
% One emulator and one calibration of the verdict a laboratory; the laboratories
% are shared out to the cores. Only twinsOfLab knows the diagnosis.
%
% Errors: DEcalioc:twinsDiagnose:runFailed
%
% See also: caseEvidence, judgeCase, foreignTwins

function verdicts = twinsDiagnose (labs, twins)
  n = numel (labs);
  [jobs, cases] = deal (cell (1, n));
  for l = 1:n
    ofLab = find ([twins.lab] == l);
    jobs{l} = struct ('name', labs(l).name, ...
                      'problem', labs(l).problem, ...
                      'data', labs(l).data, 'emulator', emulatorOf (labs(l)), ...
                      'middle', mean (labs(l).data.Z));
    cases{l} = struct ('index', ofLab, 'removed', [twins(ofLab).removed], ...
                       'Y', vertcat (twins(ofLab).y));
  end
  parts = parcellfun (min (n, nproc ()), @twinsOfLab, jobs, cases, ...
                      'UniformOutput', false, 'VerboseLevel', 0, ...
                      'ErrorHandler', @(err, varargin) err);
  for l = 1:n
    if isfield (parts{l}, 'message')
      error ('DEcalioc:twinsDiagnose:runFailed', ...
             'twinsDiagnose: laboratory %s could not be diagnosed: %s', ...
             labs(l).name, parts{l}.message);
    end
    verdicts(cases{l}.index) = parts{l};
    printf ('%s: done\n', labs(l).name);
  end
end

function emulator = emulatorOf (lab)
  emulator = [];
  if isfield (lab, 'emulator')
    emulator = lab.emulator;
  end
end

%!error <laboratory here could not be diagnosed>
%! labs = struct ('name', 'here', 'problem', 5, 'emulator', [], ...
%!                'data', struct ('Z', [1, 2]));
%! twins = struct ('lab', 1, 'removed', 0, 'y', [1, 2]);
%! twinsDiagnose (labs, twins);

% SPDX-License-Identifier: GPL-3.0-only
